// Makes zips.

import type { ZipAnswer, ZipEntry } from "../../worker/zip";

export function zip(entries: readonly ZipEntry[]): Promise<Blob> {
  const worker = new Worker(new URL("../../worker/zip.ts", import.meta.url), { type: "module", name: "zip" });
  return new Promise<Blob>((resolve, reject) => {
    worker.onmessage = ({ data }: MessageEvent<ZipAnswer>) => {
      if ("zip" in data) resolve(data.zip);
      else reject(new Error(data.error));
    };
    worker.onerror = (event) => reject(new Error(event.message || "The zip could not be made."));
    worker.postMessage(entries.map(({ path, data }) => ({ path, data })));
  }).finally(() => worker.terminate());
}
