// Opens one HDF5 file: every file of a model in it, as blobs.

import * as Comlink from "comlink";
import init, { ArrayFile } from "../generated/hdf5/hdf5.js";
import { HELD } from "../shared/zip/zip.mjs";
import { stayAlive } from "./alive";

const ready = init();

export interface OpenedArrays {
  readonly files: { path: string; data: Blob }[];
  readonly refused: { path: string; message: string }[];
  /** What else there is to say, of "it". */
  readonly notes: string[];
}

const opener = {
  /** Rejects with words for the reader. */
  async open(path: string, data: Blob): Promise<OpenedArrays> {
    await ready;
    // A blob is read piece by piece: the file need not fit into memory.
    const reader = new FileReaderSync();
    const bytes = (from: number, to: number) => new Uint8Array(reader.readAsArrayBuffer(data.slice(from, to)));
    const file = ArrayFile.open(path, data.size, bytes);
    try {
      return held(path, file);
    } finally {
      file.free();
    }
  },
};

/** All that is in a file, as far as the page holds so much: the rest is refused with a word. */
function held(path: string, file: ArrayFile): OpenedArrays {
  const found: OpenedArrays = { files: [], refused: [], notes: file.notes() };
  const entries = file.entries();
  let left = HELD.totalBytes;
  for (const [place, entry] of entries.entries()) {
    try {
      const content = file.read(place) as Uint8Array<ArrayBuffer>;
      left -= content.length;
      if (left < 0) {
        const message = `it comes to more than ${HELD.totalBytes / 2 ** 20} MiB, and the last ${entries.length - place} of ${entries.length} are left out`;
        found.refused.push({ path, message });
        break;
      }
      found.files.push({ path: entry.path, data: new Blob([content]) });
    } catch (error) {
      found.refused.push({ path: entry.path, message: error instanceof Error ? error.message : String(error) });
    }
  }
  return found;
}

export type ArrayFileWorker = typeof opener;

stayAlive();
Comlink.expose(opener);
