// What the lesson on scores holds: the part, the painting, and the engine's score of it.

import { batch, computed, signal } from "@preact/signals";
import type { LessonModel } from "../../../worker/lessons";
import type { PaintedScore } from "../../../generated/engine/engine.js";
import { latest } from "../../engine/latest";
import type { Session } from "../session";
import { listsOf, neighboursOf, paintingOf, type Painting, type Prediction } from "./selection";

export const part = signal<LessonModel | undefined>(undefined);
export const painting = signal<Painting>(new Uint8Array());
/** How far the predicted surfaces are moved off the true ones. */
export const shift = signal(0);
/** Points of the rest of the part. */
export const rest = signal(0);
export const score = signal<PaintedScore | undefined>(undefined);
/** The true primitive that is looked at. */
export const lookedAt = signal(0);
/** The prediction that the brush paints. */
export const active = signal<Prediction>(0);

/** Diagonal neighbours of the niche's grid, whose points are 0.07 apart. */
const REACH = 0.105;
/** Points of the niche itself; what comes after them belongs to the rest of the part. */
let own = 0;

export const near = computed(() => {
  const positions = part.value?.positions;
  return positions ? neighboursOf(positions.subarray(0, 3 * own), REACH) : [];
});

export const truth = computed<readonly Uint32Array[]>(() => part.value?.lists.members ?? []);

/** Loads the part with `more` points around it; the painting stays. */
export async function load({ engine }: Session, more: number): Promise<void> {
  rest.value = more;
  const loaded = await engine.niche(more);
  const count = loaded.positions.length / 3;
  own = count - more;
  const kept = new Uint8Array(count);
  kept.set(painting.value.subarray(0, own));
  batch(() => {
    part.value = loaded;
    painting.value = kept;
  });
}

/** Loads the niche alone, with an engine that has just been started; nothing of an earlier visit is left. */
export function openAnew(session: Session): Promise<void> {
  batch(() => {
    part.value = undefined;
    painting.value = new Uint8Array();
    score.value = undefined;
  });
  return load(session, 0);
}

/** Scores the painting as it is now, as often as the engine can follow. */
export function scorer({ engine }: Session): () => Promise<void> {
  const ask = latest(async (asked: { painting: Painting; shift: number }) => {
    score.value = await engine.paint(listsOf(asked.painting), asked.shift);
  });
  return () => ask({ painting: painting.value, shift: shift.value });
}

/** Paintings to begin a step with. */
export const PRESETS = {
  nothing: () => [],
  truth: () => [wall(), floor()],
  sloppy: () => [[...wall().filter((_, i) => i % 36 < 30), ...floor().filter((_, i) => i % 5 === 0)]],
  one: () => [[...wall(), ...floor()]],
  pieces: () => [0, 1, 2].map((piece) => wall().filter((point) => Math.floor(share(point) * 3) === piece)).concat([floor()]),
  edge: () => [wall(), floor().filter((point) => !wall().includes(point))],
} satisfies Record<string, () => number[][]>;

export type Preset = keyof typeof PRESETS;

export function begin(preset: Preset): void {
  const count = (part.value?.positions.length ?? 0) / 3;
  batch(() => {
    painting.value = paintingOf(count, PRESETS[preset]());
    shift.value = 0;
    active.value = 0;
  });
}

function wall(): number[] {
  return Array.from(truth.value[0] ?? []);
}

function floor(): number[] {
  return Array.from(truth.value[1] ?? []);
}

/** Where a point lies along x, 0 to just under 1. */
function share(point: number): number {
  return Math.min(0.999, ((part.value?.positions[3 * point] ?? 0) + 1) / 2);
}
