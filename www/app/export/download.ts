// Handing things over: to the disk and to the clipboard.

import { notify } from "../state/notices";

/** Long enough for every browser to have begun reading. */
const KEPT_MS = 60_000;

/** Saves a file. Browsers replace what may not stand in the name of one. */
export function download(name: string, content: Blob): void {
  const address = URL.createObjectURL(content);
  const link = document.createElement("a");
  link.href = address;
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(address), KEPT_MS);
}

export async function copy(text: string, what: string): Promise<void> {
  try {
    await navigator.clipboard.writeText(text);
    notify(`${what} copied.`);
  } catch {
    notify(`${what} could not be copied: the browser does not allow it here. Select the text and copy it by hand.`, "error");
  }
}
