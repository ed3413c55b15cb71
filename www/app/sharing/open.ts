// Opens a link: reads it, makes again what can be made again, and looks where the sharer looked.

import { batch, effect } from "@preact/signals";
import type { Report } from "../engine/contract";
import { engineVersion } from "../export/results";
import { shownPanel } from "../shell/panels";
import { arrangement, ARRANGEMENTS, colourMode, projection } from "../stage/display";
import { awaitedCamera } from "../stage/camera";
import { COLOUR_MODES } from "../stage/colouring";
import { rightIsTruth, selectedPrimitive, selectModel, showLeft, type PrimitiveRef } from "../state/selection";
import { protocol } from "../state/settings";
import { readFragment } from "./codec/link";
import { engineHere, opened, SHARED_PANEL } from "./opened";
import { entryOf, isRebuildable, rebuild, stopRebuilding } from "./rebuild";
import type { SharedResults } from "./shared";

/** More samples than this are not made unasked: a link must not keep the machine busy. */
const MAX_SAMPLES = 12;

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
  void engineVersion().then((version) => (engineHere.value = version));
  batch(() => {
    opened.value = { kind: "shared", results };
    protocol.value = results.protocol;
    shownPanel.value = SHARED_PANEL;
  });
  void restore(results);
  return true;
}

/** What the sharer looked at comes whole, with its fits; of the rest, unasked, only what is quickly made. */
async function restore(results: SharedResults): Promise<void> {
  const shown = results.view?.model;
  const looked = shown === undefined ? undefined : results.models[shown];
  const samples = results.models.flatMap(({ origin }, place) => (origin.kind === "sample" && place !== shown ? [place] : []));
  const stillShown = lookAgain(results);
  await rebuild(results, {
    models: [...(shown === undefined ? [] : [shown]), ...samples.slice(0, MAX_SAMPLES)],
    shown,
    fits: looked && isRebuildable(looked) ? results.claims.filter(({ model, fitted }) => fitted && model === shown) : [],
  });
  if (stillShown()) look(results, "submissions");
}

/**
 * As soon as the model looked at is there and scored (made again, or dropped), shows it as the sharer
 * saw it. The result tells whether that has happened.
 */
function lookAgain(results: SharedResults): () => boolean {
  const { models, view } = results;
  const model = view && models[view.model];
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
      if (!over) look(results, "everything");
    });
  });
  return () => {
    const state = opened.peek();
    return shown && state.kind === "shared" && state.results === results;
  };
}

/** Looks where the sharer looked; at the submissions again once fits are repeated, without a jump of the camera. */
function look({ models, view }: SharedResults, what: "everything" | "submissions"): void {
  const model = view && models[view.model];
  const entry = model && entryOf(model);
  if (!view || entry?.status.kind !== "scored") return;
  const { reports } = entry.status.result;
  const report = reports.find(({ method }) => method === view.method)?.definition;
  const left = reports.find(({ method }) => method === view.left)?.definition;
  batch(() => {
    selectModel(entry.id, report && view.method);
    showLeft(left && view.left);
    rightIsTruth.value = view.rightIsTruth ?? false;
    selectedPrimitive.value = view.primitive && isIn(view.primitive, report, left) ? view.primitive : undefined;
    if (what === "submissions") return;
    colourMode.value = COLOUR_MODES.find(({ id }) => id === view.colour)?.id ?? colourMode.value;
    arrangement.value = ARRANGEMENTS.find(({ id }) => id === view.arrangement)?.id ?? arrangement.value;
    if (!view.camera) return;
    projection.value = view.camera.projection;
    awaitedCamera.value = { model: entry.id, state: view.camera };
  });
}

/** A link may name any number. */
function isIn({ side, index }: PrimitiveRef, report: Report | undefined, left: Report | undefined): boolean {
  const primitives = { truth: report?.primitives, prediction: report?.predictions, rival: left?.predictions }[side];
  return index < (primitives?.length ?? 0);
}
