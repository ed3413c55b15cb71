// What can be opened from anywhere: the sheet to share and export, and the link in the address.

import { signal } from "@preact/signals";
import { opened } from "./state";
import { isShared } from "../state/fragment";

/** Whether the sheet is shown. */
export const sharing = signal(false);

/** Opens the link in the address, if there is one. False where there is none, or it is damaged. */
export async function openAddress(): Promise<boolean> {
  if (!isShared(location.hash)) return false;
  try {
    const { openLink } = await import("./open");
    return await openLink(location.hash);
  } catch (error) {
    // The part of the page that reads links did not arrive.
    const why = error instanceof Error ? error.message : String(error);
    opened.value = { kind: "damaged", message: `The link could not be opened (${why}). Check the connection and reload the page.` };
    return false;
  }
}

/** Also opens a link that is put into the address of a page already open. */
export function heedAddress(): void {
  addEventListener("hashchange", () => void openAddress());
}
