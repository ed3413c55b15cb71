// Opens one zip: every text file in it, also those of zips within, as blobs.

import { unzipSync, type UnzipFileInfo } from "fflate";

export interface UnzipRequest {
  readonly path: string;
  readonly data: Blob;
}

export interface UnzipAnswer {
  readonly files: { path: string; data: Blob }[];
  readonly refused: { path: string; reason: string }[];
}

/** The whole public repository unpacks to a fifth of this. */
const MAX_UNPACKED_BYTES = 2 ** 30;
/** A zip within a zip is opened, one within that is not. */
const MAX_DEPTH = 2;

self.onmessage = async ({ data: request }: MessageEvent<UnzipRequest>) => {
  const answer: UnzipAnswer = { files: [], refused: [] };
  try {
    const bytes = new Uint8Array(await request.data.arrayBuffer());
    open(request.path, bytes, 1, { left: MAX_UNPACKED_BYTES }, answer);
  } catch (error) {
    answer.refused.push({ path: request.path, reason: reasonOf(error) });
  }
  self.postMessage(answer);
};

function open(path: string, bytes: Uint8Array, depth: number, budget: { left: number }, answer: UnzipAnswer): void {
  const wanted = ({ name, originalSize }: UnzipFileInfo): boolean => {
    if (name.endsWith("/")) return false;
    if (/\.zip$/i.test(name) && depth >= MAX_DEPTH) {
      answer.refused.push({ path: `${path}/${name}`, reason: "A zip within a zip within a zip is not opened." });
      return false;
    }
    if (originalSize > budget.left) {
      const limit = MAX_UNPACKED_BYTES / 2 ** 20;
      answer.refused.push({ path: `${path}/${name}`, reason: `The zip unpacks to more than ${limit} MiB.` });
      return false;
    }
    budget.left -= originalSize;
    return true;
  };
  for (const [name, content] of Object.entries(unzipSync(bytes, { filter: wanted }))) {
    const inner = `${path}/${name}`;
    if (/\.zip$/i.test(name)) {
      try {
        open(inner, content, depth + 1, budget, answer);
      } catch (error) {
        answer.refused.push({ path: inner, reason: reasonOf(error) });
      }
    } else {
      answer.files.push({ path: inner, data: new Blob([content as Uint8Array<ArrayBuffer>]) });
    }
  }
}

function reasonOf(error: unknown): string {
  const what = error instanceof Error ? error.message : String(error);
  return `The zip could not be opened (${what}). Is it complete, and not encrypted?`;
}
