// What a zip holds, as the page takes it: blobs, and what is wrong in words.

import { sentence } from "../shared/text.mjs";
import { Damaged, type Source } from "../shared/zip/source.mjs";
import { HELD, listZip, type Entry } from "../shared/zip/zip.mjs";

export interface Unzipped {
  readonly files: { path: string; data: Blob }[];
  readonly refused: { path: string; reason: string }[];
}

/** Opens a zip; whatever cannot be read is refused with the reason, and the rest is there. */
export function unzipped(path: string, source: Source): Unzipped {
  const found: Unzipped = { files: [], refused: [] };
  const refuse = (name: string, message: string) => found.refused.push({ path: name, reason: sentence(message) });
  try {
    const { entries, problems } = listZip(source, HELD);
    for (const problem of problems) refuse(`${path}/${problem.path}`, problem.message);
    if (entries.length + problems.length === 0) refuse(path, "there is no file in it");
    for (const entry of entries) {
      try {
        found.files.push({ path: `${path}/${entry.path}`, data: blobOf(entry) });
      } catch (error) {
        refuse(`${path}/${entry.path}`, reasonOf(error));
      }
    }
  } catch (error) {
    refuse(path, `the zip could not be opened: ${reasonOf(error)}`);
  }
  return found;
}

/** Longer files are unpacked a piece of so many bytes at a time: of a blob the browser puts on disk what is much. */
const PIECE_BYTES = 2 ** 24;

function blobOf({ size, read, part }: Entry): Blob {
  if (size <= PIECE_BYTES) return new Blob([read() as Uint8Array<ArrayBuffer>]);
  let blob = new Blob([]);
  for (let from = 0; from < size; from += PIECE_BYTES) {
    blob = new Blob([blob, part(from, Math.min(size, from + PIECE_BYTES)) as Uint8Array<ArrayBuffer>]);
  }
  return blob;
}

function reasonOf(error: unknown): string {
  if (error instanceof Damaged) return error.message;
  return `it could not be read: ${error instanceof Error ? error.message : String(error)}`;
}
