// Makes one zip. In a worker of its own, so that neither the page nor the engine waits.

import * as Comlink from "comlink";
import { zipSync, type Zippable } from "fflate";
import { stayAlive } from "./alive";

export interface ZipEntry {
  readonly path: string;
  readonly data: Blob;
}

/** The earliest date a zip can hold: the same files make the same zip, whenever and wherever it is made. */
const DATE = "1980-01-01T00:00:00";

const zipper = {
  async zip(entries: readonly ZipEntry[]): Promise<Blob> {
    const content: Zippable = {};
    for (const { path, data } of entries) content[path] = new Uint8Array(await data.arrayBuffer());
    return new Blob([zipSync(content, { level: 6, mtime: DATE })], { type: "application/zip" });
  },
};

export type ZipWorker = typeof zipper;

stayAlive();
Comlink.expose(zipper);
