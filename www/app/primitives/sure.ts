// How sure the surfaces of the primitives in the table are by their points: asked once it is in sight.

import { computed, effect, signal } from "@preact/signals";
import type { PrimitiveInfo, StandardErrorsInfo } from "../engine/contract";
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

/** An axis or a half-angle that is off by so much, in radians, is not told by the points. */
const LOOSE_ANGLE = Math.PI / 6;
/** Nor is a radius that is off by this share of itself. */
const LOOSE_SHARE = 0.5;

/** Whether surfaces that are very different fit the points of a primitive as well: its numbers then say nothing. */
export function isLoose({ surface }: PrimitiveInfo, errors: StandardErrorsInfo | undefined): boolean {
  if (!surface || !errors) return false;
  const angle = Math.max(errors.axis ?? 0, errors.halfAngle ?? 0);
  if (angle > LOOSE_ANGLE) return true;
  switch (surface.type) {
    case "Cylinder":
    case "Sphere":
      return (errors.radius ?? 0) > LOOSE_SHARE * surface.radius;
    case "Torus":
      return (errors.radius ?? 0) > LOOSE_SHARE * surface.majorRadius || (errors.minorRadius ?? 0) > LOOSE_SHARE * surface.minorRadius;
    case "Plane":
    case "Cone":
      return false;
  }
}
