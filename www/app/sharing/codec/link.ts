// The fragment that holds results: `#share=2.…`.

import { MARK } from "../../state/fragment";
import type { SharedResults } from "../shared";
import { read, write, type FragmentFormat } from "./fragment-format";
import * as version1 from "./version1";
import * as version2 from "./version2";

export { MAX_FRAGMENT } from "./fragment-format";

const FORMAT: FragmentFormat<SharedResults> = {
  mark: MARK,
  current: 2,
  write: version2.write,
  readers: { 1: version1.read, 2: version2.read },
  tooMuch: "These are more results than one link can hold. Choose fewer methods or models.",
};

/** The fragment, with its `#`. Throws a `RangeError` where there is more than a link can hold. */
export function writeFragment(results: SharedResults): string {
  return write(FORMAT, results);
}

/** Reads a fragment of any version there has been. Throws `Damaged`, with words for the reader. */
export function readFragment(fragment: string): SharedResults {
  return read(FORMAT, fragment);
}
