// HDF5 files as the files of models that are in them, each had when its turn comes.

import { isArrayFile, oneEach } from "../../www/shared/hdf5.mjs";
import { instantiate } from "./engine.mjs";

/** @typedef {import("./inputs.mjs").File} File */
/** @typedef {import("../hdf5/hdf5.js").ArrayFile} ArrayFile */
/** @typedef {{ path: string, severity: "note" | "error", message: string }} Told */

const GLUE = new URL("../hdf5/hdf5.js", import.meta.url);
const WASM = new URL("../hdf5/hdf5_bg.wasm", import.meta.url);

/**
 * Replaces every HDF5 file by what it holds, and tells what cannot be opened. Nothing is read but the directories of
 * their arrays. Throws `NotBuilt` where what opens them is not there.
 * @param {readonly File[]} files
 * @returns {Promise<{ files: File[], told: Told[] }>}
 */
export async function openArrayFiles(files) {
  if (!files.some(({ path }) => isArrayFile(path))) {
    return { files: [...files], told: [] };
  }
  /** @type {{ module: typeof import("../hdf5/hdf5.js") }} */
  const { module } = await instantiate(GLUE.href, WASM);
  const shelf = new Shelf(module.ArrayFile);
  /** @type {File[]} */
  const found = [];
  /** @type {Told[]} */
  const errors = [];
  /** @type {Told[]} */
  const notes = [];
  for (const file of files) {
    if (!isArrayFile(file.path)) {
      found.push(file);
      continue;
    }
    try {
      const opened = shelf.open(file);
      for (const message of opened.notes()) notes.push({ path: file.path, severity: "note", message });
      for (const [place, { path, size }] of opened.entries().entries()) {
        found.push({ path, size, read: () => shelf.open(file).read(place) });
      }
    } catch (error) {
      errors.push({ path: file.path, severity: "error", message: error instanceof Error ? error.message : String(error) });
    }
  }
  return { files: found, told: [...errors, ...oneEach(notes).map((note) => ({ ...note, severity: /** @type {const} */ ("note") }))] };
}

/** The file opened last: each keeps what it has unpacked, and there may be thousands. */
class Shelf {
  /** @type {{ file: File, opened: ArrayFile } | undefined} */
  #last;

  /** @param {typeof import("../hdf5/hdf5.js").ArrayFile} kind */
  constructor(kind) {
    this.kind = kind;
  }

  /** @param {File} file */
  open(file) {
    if (this.#last?.file === file) return this.#last.opened;
    this.#last?.opened.free();
    this.#last = undefined;
    const opened = this.kind.open(file.path, file.size, partOf(file));
    this.#last = { file, opened };
    return opened;
  }
}

/**
 * What gives the bytes between two offsets.
 * @param {File} file
 */
function partOf({ read, part }) {
  if (part) return part;
  /** @type {Uint8Array | undefined} */
  let whole;
  return (/** @type {number} */ from, /** @type {number} */ to) => (whole ??= read()).subarray(from, to);
}
