// Which sample is which: a part with its options.

import type { SampleOptions } from "../engine/contract";
import type { Origin } from "../state/models";

export type SampleOrigin = Extract<Origin, { readonly kind: "sample" }>;

type Option = keyof SampleOptions;

/** In the order in which names have them. */
const OPTIONS: readonly Option[] = ["spacing", "noise", "outliers", "missing", "seed"];
/** Saying these says nothing. */
const IDLE: SampleOptions = { noise: 0, outliers: 0, missing: 0, seed: 1 };

function telling(options: SampleOptions): Option[] {
  return OPTIONS.filter((option) => options[option] !== undefined && options[option] !== IDLE[option]);
}

/** Another name for every other sample of a part: `bracket`, `bracket-noise0.001-seed9`. */
export function nameOfSample({ part, options }: Pick<SampleOrigin, "part" | "options">): string {
  return [part, ...telling(options).map((option) => `${option}${options[option]}`)].join("-");
}

/** Whether two origins are of one sample. */
export function isSameSample(a: Origin, b: Pick<SampleOrigin, "part" | "options">): boolean {
  return a.kind === "sample" && nameOfSample(a) === nameOfSample(b);
}
