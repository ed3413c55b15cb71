// Opens HDF5 files in a worker of their own. What reads them is fetched at the first.

import { oneEach } from "../../shared/hdf5.mjs";
import { sentence } from "../../shared/text.mjs";
import script from "../../worker/hdf5?worker&url";
import type { ArrayFileWorker } from "../../worker/hdf5";
import { LiveWorker } from "../engine/live-worker";
import { startWorker } from "../engine/own-script";
import type { BroughtFile } from "../state/inbox";
import type { Gathered } from "./entries";

/** The files of models in HDF5 files, and what there is to say of these. */
export async function openArrayFiles(files: readonly BroughtFile[]): Promise<Gathered> {
  const opened: Gathered = { files: [], refused: [] };
  const notes: { path: string; message: string }[] = [];
  // One that used up the memory must not take it from the next.
  for (const file of files) {
    const worker = new LiveWorker<ArrayFileWorker>((name) => startWorker(script, name), { title: "What opens HDF5" });
    try {
      const found = await worker.api.open(file.path, file.data);
      for (const message of found.notes) notes.push({ path: file.path, message });
      for (const each of found.files) opened.files.push({ ...file, ...each });
      for (const { path, message } of found.refused) opened.refused.push({ path, reason: sentence(message) });
    } catch (error) {
      opened.refused.push({ path: file.path, reason: sentence(error instanceof Error ? error.message : String(error)) });
    } finally {
      worker.end();
    }
  }
  for (const { path, message } of oneEach(notes)) opened.refused.push({ path, reason: sentence(message) });
  return opened;
}
