// Names that stand in sentences: a link's can hold anything, a whole sentence too.

import type { Names } from "./judge";

/** Most characters of a name within a sentence. */
const MAX_NAME = 40;

/** A name in quotation marks, cut to what a sentence has room for. */
export function named(name: string): string {
  const characters = Array.from(name);
  return `“${characters.length > MAX_NAME ? `${characters.slice(0, MAX_NAME - 1).join("")}…` : name}”`;
}

/** What files are called here: `model “PC7”, method “HT”`. */
export function nameWords({ model, method }: Names): string {
  return [model !== undefined && `model ${named(model)}`, method !== undefined && `method ${named(method)}`].filter((part) => part !== false).join(", ");
}
