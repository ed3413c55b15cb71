// Opens zips in a worker of their own, so that neither the page nor the engine waits.

import type { UnzipAnswer, UnzipRequest } from "../../worker/unzip";
import type { Gathered } from "./entries";

const isZip = (path: string) => /\.zip$/i.test(path);

/** Replaces every zip by what it holds. */
export async function openZips({ files, refused }: Gathered): Promise<Gathered> {
  const opened: Gathered = { files: files.filter(({ path }) => !isZip(path)), refused: [...refused] };
  const zips = files.filter(({ path }) => isZip(path));
  if (zips.length === 0) return opened;
  const worker = new Worker(new URL("../../worker/unzip.ts", import.meta.url), { type: "module", name: "unzip" });
  try {
    for (const zip of zips) {
      const answer = await ask(worker, zip);
      opened.files.push(...answer.files);
      opened.refused.push(...answer.refused);
    }
  } finally {
    worker.terminate();
  }
  return opened;
}

function ask(worker: Worker, request: UnzipRequest): Promise<UnzipAnswer> {
  return new Promise((resolve) => {
    worker.onmessage = (event: MessageEvent<UnzipAnswer>) => resolve(event.data);
    worker.onerror = (event) => {
      const reason = event.message || "The zip could not be opened.";
      resolve({ files: [], refused: [{ path: request.path, reason }] });
    };
    worker.postMessage(request);
  });
}
