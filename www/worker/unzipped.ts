// What a zip holds, as the page takes it: blobs, and what is wrong in words.

import { sentence } from "../shared/text.mjs";
import { Damaged, type Source } from "../shared/zip/source.mjs";
import { HELD, listZip } from "../shared/zip/zip.mjs";

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
    for (const entry of entries) {
      try {
        found.files.push({ path: `${path}/${entry.path}`, data: new Blob([entry.read() as Uint8Array<ArrayBuffer>]) });
      } catch (error) {
        refuse(`${path}/${entry.path}`, reasonOf(error));
      }
    }
  } catch (error) {
    refuse(path, `the zip could not be opened: ${reasonOf(error)}`);
  }
  return found;
}

function reasonOf(error: unknown): string {
  if (error instanceof Damaged) return error.message;
  return `it could not be read: ${error instanceof Error ? error.message : String(error)}`;
}
