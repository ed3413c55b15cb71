// Makes zips.

import script from "../../worker/zip?worker&url";
import type { ZipEntry, ZipWorker } from "../../worker/zip";
import { LiveWorker } from "../engine/live-worker";
import { startWorker } from "../engine/own-script";

const start = (name: string) => startWorker(script, name);

export async function zip(entries: readonly ZipEntry[]): Promise<Blob> {
  const worker = new LiveWorker<ZipWorker>(start, { title: "What makes zips" });
  try {
    return await worker.api.zip(entries.map(({ path, data }) => ({ path, data })));
  } finally {
    worker.end();
  }
}
