// The fragment that holds a case: `#case=1.…`.

import { bare } from "../../sharing/fragment";
import { read, write, type FragmentFormat } from "../../sharing/codec/fragment-format";
import type { Case } from "../case";
import * as version1 from "./version1";

const FORMAT: FragmentFormat<Case> = {
  mark: "case=",
  current: 1,
  write: version1.write,
  readers: { 1: version1.read },
  tooMuch: "This case has more blocks or cuts than one link can hold. Save its files instead.",
};

/** Whether a fragment (with or without `#`) is meant to hold a case. */
export function isCase(fragment: string): boolean {
  return bare(fragment).startsWith(FORMAT.mark);
}

/** The fragment, with its `#`. Throws a `RangeError` where there is more than a link can hold. */
export function writeCase(of: Case): string {
  return write(FORMAT, of);
}

/** Reads a fragment of any version there has been. Throws `Damaged`, with words for the reader. */
export function readCase(fragment: string): Case {
  return read(FORMAT, fragment);
}
