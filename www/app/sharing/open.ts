// Opens a link: reads it, makes again what can be made again, and looks where the sharer looked.

import { batch, effect } from "@preact/signals";
import type { Report } from "../engine/contract";
import { engineVersion } from "../export/results";
import { makeSample } from "../samples/samples";
import { shownPanel } from "../shell/panels";
import { arrangement, ARRANGEMENTS, colourMode, projection } from "../stage/display";
import { awaitedCamera } from "../stage/camera";
import { COLOUR_MODES } from "../stage/colouring";
import { modelById } from "../state/models";
import { selectedPrimitive, selectModel, type PrimitiveRef } from "../state/selection";
import { protocol } from "../state/settings";
import type { ScoredModel } from "../../worker/protocol";
import { readFragment } from "./codec/link";
import { engineHere, opened, SHARED_PANEL } from "./opened";
import type { SharedModel, SharedResults, SharedView } from "./shared";

/** More samples than this are not made anew: a link must not keep the machine busy. */
const MAX_SAMPLES = 12;

/** Opens what the fragment holds; false where it is damaged, which the page then says. */
export async function openLink(fragment: string): Promise<boolean> {
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
  for (const model of samplesOf(results).slice(0, MAX_SAMPLES)) {
    if (model.origin.kind === "sample") await makeSample(model.origin.part, model.origin.options);
  }
  lookAgain(results);
  return true;
}

/** Those that can be made again, what the sharer looked at first. */
function samplesOf({ models, view }: SharedResults): SharedModel[] {
  const shown = view && models[view.model];
  return models.filter(({ origin }) => origin.kind === "sample").sort((a, b) => Number(b === shown) - Number(a === shown));
}

/** Once the model looked at is there and scored (made again, or dropped), shows it as the sharer saw it. */
function lookAgain(results: SharedResults): void {
  const { models, view } = results;
  const name = view && models[view.model]?.name;
  if (!view || name === undefined) return;
  let waiting = true;
  const end = effect(() => {
    const state = opened.value;
    // Another link was opened, or this one closed.
    const over = state.kind !== "shared" || state.results !== results;
    const status = modelById(name)?.status;
    if (!waiting || (!over && status?.kind !== "scored")) return;
    waiting = false;
    // Not within the effect: what is set here must not be what the effect depends on.
    queueMicrotask(() => {
      end();
      if (!over && status?.kind === "scored") look(name, view, status.result);
    });
  });
}

function look(name: string, view: SharedView, { reports }: ScoredModel): void {
  const report = reports.find(({ method }) => method === view.method)?.definition;
  batch(() => {
    selectModel(name, report && view.method);
    selectedPrimitive.value = view.primitive && report && isIn(report, view.primitive) ? view.primitive : undefined;
    colourMode.value = COLOUR_MODES.find(({ id }) => id === view.colour)?.id ?? colourMode.value;
    arrangement.value = ARRANGEMENTS.find(({ id }) => id === view.arrangement)?.id ?? arrangement.value;
    if (!view.camera) return;
    projection.value = view.camera.projection;
    awaitedCamera.value = { model: name, state: view.camera };
  });
}

/** A link may name any number. */
function isIn({ primitives, predictions }: Report, { side, index }: PrimitiveRef): boolean {
  return index < (side === "truth" ? primitives : predictions).length;
}
