// One road in for everything: dropped, chosen, pasted, downloaded.

import { signal } from "@preact/signals";
import { isArrayFile } from "../../shared/hdf5.mjs";
import { notify } from "../state/notices";
import { receive } from "../state/arrivals";
import { goToPanel } from "../state/panels";
import { CAD_PANEL } from "../state/step";
import { gatherChosen, gatherDrop, type Gathered } from "./entries";
import { openParts } from "./step";
import { openZips } from "./unzip";

/** Whether files are being read or sorted just now. */
export const taking = signal(false);

export function takeDrop(transfer: DataTransfer): Promise<void> {
  return take(gatherDrop(transfer));
}

export function takeChosen(list: FileList): Promise<void> {
  return take(Promise.resolve(gatherChosen(list)));
}

/** Takes a text as if it were a file of the given name. */
export function takeText(path: string, text: string): Promise<void> {
  return take(Promise.resolve({ files: [{ path, data: new Blob([text]) }], refused: [] }));
}

/** Takes files that the page fetched, as if they had been dropped. */
export function takeDownloaded(gathered: Gathered): Promise<void> {
  return take(Promise.resolve(gathered));
}

/** Replaces every HDF5 file by what it holds. What opens them is fetched where there is one. */
async function openArrays({ files, refused }: Gathered): Promise<Gathered> {
  const arrays = files.filter(({ path }) => isArrayFile(path));
  if (arrays.length === 0) return { files, refused };
  const { openArrayFiles } = await import("./hdf5");
  const opened = await openArrayFiles(arrays);
  return { files: [...files.filter(({ path }) => !isArrayFile(path)), ...opened.files], refused: [...refused, ...opened.refused] };
}

async function take(gathering: Promise<Gathered>): Promise<void> {
  taking.value = true;
  try {
    const { files, refused, parts } = await openParts(await openArrays(await openZips(await gathering)));
    if (files.length + refused.length > 0) await receive(files, refused);
    // Of more than a few, the files that were received say enough.
    if (parts.length > 0 && parts.length <= 3) notify(parts.join(" "), "info", { title: "Faces and options", run: () => goToPanel(CAD_PANEL) });
  } catch (error) {
    notify(error instanceof Error ? error.message : String(error), "error");
  } finally {
    taking.value = false;
  }
}
