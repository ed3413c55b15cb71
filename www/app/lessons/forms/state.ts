// What the lesson on both forms holds: a true surface, a predicted one, and what the engine says of them.

import { computed, signal } from "@preact/signals";
import { SURFACE_TYPES } from "../../../generated/declared/surface-types.js";
import type { FormComparison, Forms, SurfaceSliders, SurfaceType } from "../../../generated/engine/engine.js";
import { latest } from "../../engine/latest";
import type { Session } from "../session";

export const FAMILIES: readonly SurfaceType[] = SURFACE_TYPES.map(({ name }) => name);

const START: Readonly<Record<SurfaceType, SurfaceSliders>> = {
  Plane: { type: "Plane", at: [0, 0, 0.3], tilt: 20, heading: 30, size: 1, minor: 0.2 },
  Cylinder: { type: "Cylinder", at: [0, 0, 0], tilt: 0, heading: 0, size: 0.6, minor: 0.2 },
  Cone: { type: "Cone", at: [0, 0, 0.8], tilt: 0, heading: 0, size: 25, minor: 0.2 },
  Sphere: { type: "Sphere", at: [0.2, 0, 0], tilt: 0, heading: 0, size: 0.8, minor: 0.2 },
  Torus: { type: "Torus", at: [0, 0, 0], tilt: 0, heading: 0, size: 0.8, minor: 0.25 },
};

/** The predicted surface, which the reader moves. */
export const sliders = signal<SurfaceSliders>(START.Cylinder);
/** The true surface: where the family begins. */
export const truthSliders = computed(() => START[sliders.value.type]);
/** What the predicted implicit vector is multiplied by. */
export const factor = signal(1);
/** Rounding noise put in the place of one entry of both vectors, with opposite signs. */
export const noise = signal<{ readonly entry: number; readonly size: number }>({ entry: 3, size: 0 });

export const predicted = signal<Forms | undefined>(undefined);
export const truth = signal<Forms | undefined>(undefined);
export const comparison = signal<FormComparison | undefined>(undefined);

/** The implicit vectors that are compared, prediction and truth. */
export const vectors = computed<readonly [number[], number[]] | undefined>(() => {
  if (!predicted.value || !truth.value) return undefined;
  const { entry, size } = noise.value;
  const spoilt = (values: readonly number[], by: number) => values.map((each, place) => (size > 0 && place === entry ? by : each));
  return [
    spoilt(predicted.value.implicit.map((each) => each * factor.value), -size),
    spoilt(truth.value.implicit, size),
  ];
});

export function choose(family: SurfaceType): void {
  sliders.value = START[family];
  factor.value = 1;
  noise.value = { entry: noise.value.entry, size: 0 };
}

/** Keeps forms and comparison in step with what is set, as fast as the engine can. */
export function follower({ engine }: Session): { forms: () => Promise<void>; compare: () => Promise<void> } {
  const askForms = latest(async (asked: readonly [SurfaceSliders, SurfaceSliders]) => {
    const [next, fixed] = await Promise.all([engine.forms(asked[0]), engine.forms(asked[1])]);
    truth.value = fixed;
    predicted.value = next;
  });
  const askComparison = latest(async (asked: readonly [number[], number[]]) => {
    comparison.value = await engine.compare(...asked);
  });
  return {
    forms: () => askForms([sliders.value, truthSliders.value]),
    compare: () => (vectors.value ? askComparison(vectors.value) : Promise.resolve()),
  };
}
