// Which sample is which: a part with its options.

import { SAMPLE_OPTIONS } from "../../generated/declared/sample-options.js";
import type { SampleOptions } from "../engine/contract";
import type { Origin } from "../state/origin";

export type SampleOrigin = Extract<Origin, { readonly kind: "sample" }>;

type Option = keyof SampleOptions;

/** What an option is where it is not given. */
export function initialOf(option: Option): number {
  return SAMPLE_OPTIONS.find(({ name }) => name === option)?.default ?? 0;
}

/** Those that say something: to ask for what is so anyway says nothing. */
function telling(options: SampleOptions): Option[] {
  const said = SAMPLE_OPTIONS.filter(({ name, default: initial }) => options[name] !== undefined && options[name] !== initial);
  return said.map(({ name }) => name);
}

/** Another name for every other sample of a part: `bracket`, `bracket-noise0.001-seed9`. */
export function nameOfSample({ part, options }: Pick<SampleOrigin, "part" | "options">): string {
  return [part, ...tellingWords(options)].join("-");
}

function tellingWords(options: SampleOptions): string[] {
  return telling(options).map((option) => `${option}${options[option]}`);
}

/** Whether two origins are of one sample. */
export function isSameSample(a: Origin, b: Pick<SampleOrigin, "part" | "options">): boolean {
  return a.kind === "sample" && a.part === b.part && tellingWords(a.options).join() === tellingWords(b.options).join();
}
