// The cross-section that goes with the cut of the views.

import { computed, effect, signal } from "@preact/signals";
import type { SectionInfo } from "../engine/contract";
import { engine } from "../engine/client";
import { latest } from "../engine/latest";
import { segmentationOf } from "../stage/colouring";
import { cut } from "../stage/display";
import { modelById } from "../state/models";
import { notify } from "../state/notices";
import { scene } from "../state/scene";
import { selectedModel, type Side } from "../state/selection";
import type { ModelScene, ModelSource } from "../../worker/protocol";

/** How thick the layer of points is, as a share of the diagonal of the cloud's box. */
export const thickness = signal(0.01);

const chosen = signal<Side | undefined>(undefined);

/** Whose curves can be drawn. */
export const offered = computed<readonly Side[]>(() => {
  const state = scene.value;
  if (state.kind !== "ready") return [];
  return (["truth", "prediction", "rival"] as const).filter((side) => segmentationOf(state.scene, side) !== undefined);
});

/** Whose curves are drawn: of a method where there is one, until the reader chooses. */
export const drawnSide = computed<Side | undefined>(() => {
  const all = offered.value;
  return all.find((side) => side === chosen.value) ?? all.find((side) => side === "prediction") ?? all[0];
});

export function draw(side: Side): void {
  chosen.value = side;
}

interface Question {
  readonly source: ModelSource;
  readonly scene: ModelScene;
  readonly side: Side;
  readonly method: string | undefined;
  readonly cut: { readonly axis: number; readonly share: number };
  readonly thickness: number;
}

export interface Section extends Question {
  readonly info: SectionInfo;
}

const question = computed<Question | undefined>(() => {
  const [state, side] = [scene.value, drawnSide.value];
  const source = modelById(selectedModel.value)?.source;
  if (state.kind !== "ready" || source?.key !== state.scene.key || !side || !cut.value) return undefined;
  const { method, rival } = state.scene;
  const methods = { truth: undefined, prediction: method, rival: rival?.method };
  return { source, scene: state.scene, side, method: methods[side], cut: cut.value, thickness: thickness.value };
});

/** The last answer. */
export const section = signal<Section | undefined>(undefined);

/** The cut may move faster than it is answered. */
const ask = latest(async (asked: Question | undefined) => {
  const info = asked && (await engine.run((api) => api.section(asked.source, asked.method, asked.cut.axis, asked.cut.share, asked.thickness)));
  section.value = asked && info && { ...asked, info };
});

/** Keeps the section in step until the result is called. */
export function follow(): () => void {
  return effect(() => {
    ask(question.value).catch((error: unknown) => notify(error instanceof Error ? error.message : String(error), "error"));
  });
}
