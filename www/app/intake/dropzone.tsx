// The whole page takes drops; while something is dragged over it, it says so.

import type { JSX } from "preact";
import { signal } from "@preact/signals";
import { Icon } from "../ui/icon";
import { takeDrop } from "./intake";

/** Whether files are held over the page. */
const over = signal(false);

/**
 * Takes drops from now on. Called before anything is drawn and not as an effect of the drawing: a browser
 * that finds nobody to take a drop leaves the page and shows the file instead.
 */
export function listenForDrops(): void {
  window.addEventListener("dragenter", welcome);
  window.addEventListener("dragover", welcome);
  window.addEventListener("dragleave", (event) => {
    // Leaving the window has no element it goes to.
    if (event.relatedTarget === null) over.value = false;
  });
  // Not sent during a drag: one whose element went away from under it may end without a word.
  window.addEventListener("pointermove", () => (over.value = false));
  window.addEventListener("drop", (event) => {
    over.value = false;
    if (!event.dataTransfer || !carriesFiles(event)) return;
    event.preventDefault();
    void takeDrop(event.dataTransfer);
  });
}

/**
 * Says that files may be let go. Of every element that is entered as well as of every move: what is under the files
 * may have just come there, and a drop before the next move would go to an element that had not agreed to take it.
 */
function welcome(event: DragEvent): void {
  if (!carriesFiles(event)) return;
  event.preventDefault();
  over.value = true;
}

function carriesFiles(event: DragEvent): boolean {
  return event.dataTransfer?.types.includes("Files") ?? false;
}

export function DropZone(): JSX.Element | null {
  if (!over.value) return null;
  return (
    <div class="dropzone" aria-hidden="true">
      <p>
        <Icon name="drop" />
        Drop files, folders or zips
        <small>They are read here, in your browser, and go nowhere.</small>
      </p>
    </div>
  );
}
