// A sample: its part and how it is sampled, from which it is made again.

import { isSameSample } from "../../samples/identity";
import type { Entrance } from "../../state/arrivals";
import type { Origin } from "../../state/origin";
import type { SharedOrigin } from "../shared";
import type { Page } from "./page";

type Here = Extract<Origin, { readonly kind: "sample" }>;
type Shared = Extract<SharedOrigin, { readonly kind: "sample" }>;

export function collect({ part, options }: Here): Shared {
  return { kind: "sample", part, options };
}

/** Has the sample on the page, with its imperfect submission. Where it cannot be made, the page says why. */
export function rebuild({ part, options }: Shared, how: Entrance, page: Page, stopped: AbortSignal): Promise<void> {
  return page.makeSample(part, options, how, stopped);
}

export function isOf(here: Origin, shared: Shared): boolean {
  return isSameSample(here, shared);
}
