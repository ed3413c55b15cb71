// Opens zips in a worker of their own, so that neither the page nor the engine waits.

import script from "../../worker/unzip?worker&url";
import type { UnzipWorker } from "../../worker/unzip";
import type { Unzipped } from "../../worker/unzipped";
import { LiveWorker } from "../engine/live-worker";
import { startWorker } from "../engine/own-script";
import type { Gathered } from "./entries";

const isZip = (path: string) => /\.zip$/i.test(path);

const start = (name: string) => startWorker(script, name);

/** Replaces every zip by what it holds. */
export async function openZips({ files, refused }: Gathered): Promise<Gathered> {
  const opened: Gathered = { files: files.filter(({ path }) => !isZip(path)), refused: [...refused] };
  for (const zip of files.filter((file) => isZip(file.path))) {
    const { files: found, refused: lacking } = await open(zip.path, zip.data);
    // What is in a zip came the way the zip came.
    for (const file of found) opened.files.push({ ...zip, ...file });
    for (const file of lacking) opened.refused.push(file);
  }
  return opened;
}

/** One that used up the memory must not take it from the next: each has a worker to itself. */
async function open(path: string, data: Blob): Promise<Unzipped> {
  const worker = new LiveWorker<UnzipWorker>(start, { title: "What opens zips" });
  try {
    return await worker.api.open(path, data);
  } catch (error) {
    const reason = error instanceof Error ? error.message : String(error);
    return { files: [], refused: [{ path, reason }] };
  } finally {
    worker.end();
  }
}
