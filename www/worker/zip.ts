// Makes one zip. In a worker of its own, so that neither the page nor the engine waits.

import { zipSync, type Zippable } from "fflate";

export interface ZipEntry {
  readonly path: string;
  readonly data: Blob;
}

export type ZipAnswer = { readonly zip: Blob } | { readonly error: string };

/** The earliest date a zip can hold: the same files make the same zip, whenever and wherever it is made. */
const DATE = "1980-01-01T00:00:00";

self.onmessage = async ({ data: entries }: MessageEvent<readonly ZipEntry[]>) => {
  self.postMessage(await zip(entries));
};

async function zip(entries: readonly ZipEntry[]): Promise<ZipAnswer> {
  try {
    const content: Zippable = {};
    for (const { path, data } of entries) content[path] = new Uint8Array(await data.arrayBuffer());
    return { zip: new Blob([zipSync(content, { level: 6, mtime: DATE })], { type: "application/zip" }) };
  } catch (error) {
    return { error: error instanceof Error ? error.message : String(error) };
  }
}
