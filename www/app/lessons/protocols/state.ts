// What the lesson on protocols holds: a part, a prediction made of its true segments, and what every
// protocol says of it.

import { batch, computed, signal } from "@preact/signals";
import type { FieldReport, Figure } from "../../engine/contract";
import type { LessonModel } from "../../../worker/lessons";
import { latest } from "../../engine/latest";
import type { Session } from "../session";

/** A part with large faces, equal ones, and two below half a per cent of its points. */
const PART = "bracket";
const SPACING = 0.012;

export const part = signal<LessonModel | undefined>(undefined);
/** For each true segment the group of the prediction that it is put into; undefined where it is dropped. */
export const groups = signal<readonly (number | undefined)[]>([]);
/** Groups of fewer points are dropped. */
export const least = signal(0);
/** Of each segment every so manieth point is predicted. */
export const stride = signal(1);
export const report = signal<FieldReport | undefined>(undefined);
/** What the protocols say of the truth itself. */
export const ofTruth = signal<FieldReport | undefined>(undefined);
/** The segment that the buttons are about. */
export const chosen = signal(0);

export const members = computed<readonly Uint32Array[]>(() => part.value?.lists.members ?? []);

/** The segments by how many points they have, most first. */
export const bySize = computed(() =>
  members.value.map((_, place) => place).sort((one, other) => (members.value[other]?.length ?? 0) - (members.value[one]?.length ?? 0)),
);

/** A list of the prediction, and the first of the segments that it is made of. */
export interface Predicted {
  readonly place: number;
  readonly points: Uint32Array;
}

export const predicted = computed<readonly Predicted[]>(() => {
  const merged = new Map<number, { readonly place: number; readonly points: Set<number> }>();
  members.value.forEach((points, place) => {
    const group = groups.value[place];
    if (group === undefined) return;
    const list = merged.get(group) ?? { place, points: new Set() };
    points.forEach((point, at) => at % stride.value === 0 && list.points.add(point));
    merged.set(group, list);
  });
  const kept = [...merged.values()].filter(({ points }) => points.size >= least.value);
  return kept.map(({ place, points }) => ({ place, points: Uint32Array.from(points).sort() }));
});

/** The lists of the prediction. */
export const lists = computed<readonly Uint32Array[]>(() => predicted.value.map(({ points }) => points));

/** Loads the part; nothing of an earlier visit is left. */
export async function open({ engine }: Session): Promise<void> {
  batch(() => {
    part.value = undefined;
    report.value = undefined;
    groups.value = [];
  });
  const loaded = await engine.part(PART, { spacing: SPACING });
  const truth = await engine.field([...loaded.lists.members]);
  batch(() => {
    part.value = loaded;
    ofTruth.value = truth;
  });
}

/** Asks every protocol about the prediction as it is now, as often as the engine can follow. */
export function asker({ engine }: Session): () => Promise<void> {
  const ask = latest(async (asked: readonly Uint32Array[]) => {
    report.value = await engine.field([...asked]);
  });
  return () => ask(lists.value);
}

/** Predictions to begin with. */
export const PRESETS = {
  truth: () => members.value.map((_, place) => place),
  largest: () => members.value.map((_, place) => (place === bySize.value[0] ? place : undefined)),
  one: () => members.value.map(() => 0),
  /** Two at a time, the largest with the next. */
  pairs: () => {
    const places = new Map(bySize.value.map((place, at) => [place, at >> 1]));
    return members.value.map((_, place) => places.get(place));
  },
  /** The segments of the smaller half in one group, as a method does that grows over edges. */
  merged: () => {
    const small = new Set(bySize.value.slice(Math.ceil(members.value.length / 2)));
    return members.value.map((_, place) => (small.has(place) ? members.value.length : place));
  },
} satisfies Record<string, () => readonly (number | undefined)[]>;

export type Preset = keyof typeof PRESETS;

export function begin(preset: Preset): void {
  batch(() => {
    groups.value = PRESETS[preset]();
    least.value = 0;
    stride.value = 1;
    chosen.value = bySize.value[0] ?? 0;
  });
}

export function isDropped(place: number): boolean {
  return groups.value[place] === undefined;
}

/** Drops a segment, or takes it up again on its own. */
export function toggle(place: number): void {
  groups.value = groups.value.map((group, at) => (at === place ? (group === undefined ? place : undefined) : group));
}

/** Puts a segment into the group of another; a dropped one is taken up with it. */
export function merge(place: number, into: number): void {
  const group = groups.value[into] ?? into;
  groups.value = groups.value.map((own, at) => (at === place || at === into ? group : own));
}

export function valueOf(figure: Figure, of = report.value): number {
  return of?.figures[figure] ?? 0;
}
