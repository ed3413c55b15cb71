// @ts-check
// What page and command line share of HDF5, which a wasm module of its own opens: files of networks that fit
// primitives, each of one model or of many.

import { FILE_KINDS } from "../generated/declared/file-kinds.js";

const ENDINGS = FILE_KINDS.flatMap(({ endings, openedApart }) => (openedApart ? endings.map((ending) => `.${ending}`) : []));

/**
 * Whether a file is called as HDF5 files are.
 * @param {string} path
 */
export function isArrayFile(path) {
  const name = path.toLowerCase();
  return ENDINGS.some((ending) => name.endsWith(ending));
}

/** @typedef {{ path: string, message: string }} Note about a file, of "it" */

/**
 * One note for all files of which the same is to be said.
 * @param {readonly Note[]} notes
 * @returns {Note[]}
 */
export function oneEach(notes) {
  /** @type {Map<string, Note[]>} */
  const alike = new Map();
  for (const note of notes) alike.set(note.message, [...(alike.get(note.message) ?? []), note]);
  return Array.from(alike, ([message, [first, ...more]]) => ({
    path: first?.path ?? "",
    message: more.length === 0 ? message : `${message}. So it is with ${more.length} more of the files`,
  }));
}
