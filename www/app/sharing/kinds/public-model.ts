// A public model: its set and number, by which it is downloaded again.

import { SETS } from "../../public/catalogue";
import type { Origin, PublicModel } from "../../state/origin";
import type { SharedOrigin } from "../shared";
import type { Page } from "./page";

type Here = Extract<Origin, { readonly kind: "public" }>;
type Shared = Extract<SharedOrigin, { readonly kind: "public" }>;

/** A public model to be downloaded, with the published results or without. */
export interface Asked {
  readonly model: PublicModel;
  readonly withResults: boolean;
}

export function collect({ model }: Here): Shared {
  return { kind: "public", model };
}

/** Downloads the models, each set in one go. What does not arrive is told by the page. False where the reader stopped it. */
export async function rebuild(asked: readonly Asked[], page: Page, stopped: AbortSignal): Promise<boolean> {
  for (const { name: set } of SETS) {
    for (const withResults of [false, true]) {
      const wanted = asked.filter(({ model, withResults: own }) => model.set === set && own === withResults);
      if (wanted.length === 0) continue;
      if (stopped.aborted) return false;
      const ending = await page.download({ set, numbers: wanted.map(({ model }) => model.number), withResults }, stopped);
      if (ending === "stopped") return false;
    }
  }
  return true;
}

export function isOf(here: Origin, { model }: Shared): boolean {
  return here.kind === "public" && here.model.set === model?.set && here.model.number === model.number;
}
