// The fragment that holds a case: `#case=2.…`.

import { bare } from "../../state/fragment";
import { read, write, type FragmentFormat } from "../../sharing/codec/fragment-format";
import type { LinkedCase } from "./linked";
import * as version1 from "./version1";
import * as version2 from "./version2";

const FORMAT: FragmentFormat<LinkedCase> = {
  mark: "case=",
  current: 2,
  write: version2.write,
  readers: { 1: version1.read, 2: version2.read },
  tooMuch: "This case has more blocks or cuts than one link can hold. Save its files instead.",
};

/** Whether a fragment (with or without `#`) is meant to hold a case. */
export function isCase(fragment: string): boolean {
  return bare(fragment).startsWith(FORMAT.mark);
}

/** The fragment, with its `#`. Throws a `RangeError` where there is more than a link can hold. */
export function writeCase(linked: LinkedCase): string {
  return write(FORMAT, linked);
}

/** Reads a fragment of any version there has been. Throws `Damaged`, with words for the reader. */
export function readCase(fragment: string): LinkedCase {
  return read(FORMAT, fragment);
}
