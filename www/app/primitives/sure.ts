// How sure the surfaces of the primitives in the table are by their points: asked once it is in sight.

import { computed, effect, signal } from "@preact/signals";
import type { StandardErrorsInfo } from "../engine/contract";
import { engine } from "../engine/client";
import { latest } from "../engine/latest";
import { modelById } from "../state/models";
import { notify } from "../state/notices";
import { scene } from "../state/scene";
import { selectedModel } from "../state/selection";
import type { ModelScene, ModelSource } from "../../worker/protocol";

interface Question {
  readonly source: ModelSource;
  readonly scene: ModelScene;
  readonly method: string;
}

const question = computed<Question | undefined>(() => {
  const state = scene.value;
  const source = modelById(selectedModel.value)?.source;
  if (state.kind !== "ready" || source?.key !== state.scene.key) return undefined;
  const { method } = state.scene;
  return method === undefined ? undefined : { source, scene: state.scene, method };
});

/** The last answer: of the primitives of the scene's method, in their order. */
const answer = signal<{ readonly scene: ModelScene; readonly errors: readonly StandardErrorsInfo[] } | undefined>(undefined);

const ask = latest(async (asked: Question | undefined) => {
  const errors = asked && (await engine.run((api) => api.standardErrors(asked.source, asked.method)));
  answer.value = asked && errors && { scene: asked.scene, errors };
});

/** Keeps the answer in step until the result is called. */
export function follow(): () => void {
  return effect(() => {
    ask(question.value).catch((error: unknown) => notify(error instanceof Error ? error.message : String(error), "error"));
  });
}

/** Nothing until it is known. */
export function errorsOf(shown: ModelScene): readonly StandardErrorsInfo[] | undefined {
  return answer.value?.scene === shown ? answer.value.errors : undefined;
}
