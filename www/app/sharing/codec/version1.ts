// Version 1 of what a link holds: read for ever, written no more.

import type { SharedResults } from "../shared";
import { readLayout, type Layout } from "./layout";

const LAYOUT: Layout = {
  sides: ["truth", "prediction"],
  viewFields: 0b001_1111,
  // It did not say which.
  readPublic: () => ({ kind: "public" }),
  readFitted: () => [],
};

export function read(bytes: Uint8Array<ArrayBuffer>): SharedResults {
  return readLayout(LAYOUT, bytes);
}
