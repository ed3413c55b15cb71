// The case studio: a benchmark case of one's own, with its ground truth.

import type { JSX } from "preact";
import { useEffect } from "preact/hooks";
import { versionWords } from "../sharing/version";
import { Canvas } from "./canvas";
import { MissingSection } from "./missing-section";
import { PartSection } from "./part-section";
import { SamplingSection } from "./sampling-section";
import { SaveSection } from "./save-section";
import { close, damaged, engineHere, linkedWith, open, readAddress, redo, redoable, undo, undoable } from "./state";
import "./studio.css";

export default function Studio(): JSX.Element {
  useEffect(() => {
    open();
    addEventListener("hashchange", readAddress);
    addEventListener("keydown", onKey);
    return () => {
      removeEventListener("hashchange", readAddress);
      removeEventListener("keydown", onKey);
      close();
    };
  }, []);
  return (
    <div class="studio">
      <div class="studio-side" role="region" aria-label="The case" tabIndex={0}>
        <div class="studio-head">
          <h2>Case studio</h2>
          <div class="row">
            <button type="button" disabled={undoable.value === undefined} title={titleOf("Undo", undoable.value, "Ctrl+Z")} onClick={undo}>
              Undo
            </button>
            <button type="button" disabled={redoable.value === undefined} title={titleOf("Redo", redoable.value, "Ctrl+Shift+Z")} onClick={redo}>
              Redo
            </button>
          </div>
        </div>
        {damaged.value !== undefined && (
          <p class="studio-damaged" role="alert">
            {damaged.value}
            <button type="button" class="link" onClick={() => (damaged.value = undefined)}>
              Close
            </button>
          </p>
        )}
        <OtherEngine />
        <PartSection />
        <SamplingSection />
        <MissingSection />
        <SaveSection />
      </div>
      <Canvas />
    </div>
  );
}

/** Another version of the engine may make other points of the same case. */
function OtherEngine(): JSX.Element | null {
  const [theirs, here] = [linkedWith.value, engineHere.value];
  if (theirs === undefined || here === undefined || theirs === here) return null;
  return (
    <p class="hint" role="status">
      The link was made with {versionWords(theirs)}, this is engine {here}: the points may be others.
    </p>
  );
}

function titleOf(what: string, step: string | undefined, keys: string): string {
  return step === undefined ? `${what} (${keys})` : `${what}: ${step} (${keys})`;
}

function onKey(event: KeyboardEvent): void {
  if (!(event.ctrlKey || event.metaKey) || event.altKey || document.querySelector("dialog[open]")) return;
  const key = event.key.toLowerCase();
  const does = key === "z" ? (event.shiftKey ? redo : undo) : key === "y" && !event.shiftKey ? redo : undefined;
  // In a field whose text has not been taken over yet, the browser undoes the typing.
  const field = event.target;
  const typing = field instanceof HTMLInputElement && field.dataset["committed"] !== undefined && field.value !== field.dataset["committed"];
  if (!does || typing) return;
  event.preventDefault();
  does();
}
