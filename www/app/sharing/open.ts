// Opens a link: reads it, makes again what is quickly made again, and looks where the sharer looked.

import { batch, effect } from "@preact/signals";
import { engineVersion } from "../export/results";
import { shownPanel } from "../state/panels";
import { lend, protocol } from "../state/settings";
import { readFragment } from "./codec/link";
import * as view from "./kinds/view";
import { look } from "./looking";
import { followLink } from "./opened";
import { unaskedOf } from "./plan";
import { entryOf, rebuild } from "./rebuild";
import type { SharedResults } from "./shared";
import { engineHere, opened, SHARED_PANEL, stopRebuilding } from "./state";

/** Opens what the fragment holds; false where it is damaged, which the page then says. */
export async function openLink(fragment: string): Promise<boolean> {
  stopRebuilding();
  let results: SharedResults;
  try {
    results = readFragment(fragment);
  } catch (error) {
    opened.value = { kind: "damaged", message: error instanceof Error ? error.message : String(error) };
    return false;
  }
  followLink();
  void engineVersion().then((version) => (engineHere.value = version));
  batch(() => {
    opened.value = { kind: "shared", results };
    lend(protocol, results.protocol);
    shownPanel.value = SHARED_PANEL;
  });
  void restore(results);
  return true;
}

async function restore(results: SharedResults): Promise<void> {
  const stillShown = lookAgain(results);
  await rebuild(results, unaskedOf(results), { unasked: true });
  if (stillShown()) lookAt(results, "submissions");
}

/**
 * As soon as the model looked at is there and scored (made again, or dropped), shows it as the sharer
 * saw it. The result tells whether that has happened.
 */
function lookAgain(results: SharedResults): () => boolean {
  const { models, view: seen } = results;
  const model = seen && models[seen.model];
  if (!model) return () => false;
  let waiting = true;
  let shown = false;
  const end = effect(() => {
    const state = opened.value;
    // Another link was opened, or this one closed.
    const over = state.kind !== "shared" || state.results !== results;
    const scored = entryOf(model)?.status.kind === "scored";
    if (!waiting || (!over && !scored)) return;
    waiting = false;
    shown = !over;
    // Not within the effect: what is set here must not be what the effect depends on.
    queueMicrotask(() => {
      end();
      if (!over) lookAt(results, "everything");
    });
  });
  return () => {
    const state = opened.peek();
    return shown && state.kind === "shared" && state.results === results;
  };
}

/** Looks where the sharer looked; at the submissions again once fits are repeated, without a jump of the camera. */
function lookAt({ models, view: seen }: SharedResults, what: "everything" | "submissions"): void {
  const model = seen && models[seen.model];
  const entry = model && entryOf(model);
  if (!seen || entry?.status.kind !== "scored") return;
  look(view.rebuild(seen, entry.id, entry.status.result.reports), what);
}
