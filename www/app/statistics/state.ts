// The models on the page in numbers, one by one and set by set.

import { computed, effect, signal } from "@preact/signals";
import { engine } from "../engine/client";
import type { DatasetStatistics, ModelStatistics } from "../engine/contract";
import { latest } from "../engine/latest";
import { survey } from "../engine/survey";
import { models } from "../state/models";
import { notify } from "../state/notices";
import { truthOnly } from "../state/content";
import { LOOSE, setsOf } from "./sets";

export const counts = survey<ModelStatistics>((api, source) => api.statistics(source));

export interface CountedModel {
  readonly id: string;
  readonly set: string;
  readonly statistics: ModelStatistics;
}

const truths = computed(() => models.value.map(({ id, origin, source }) => ({ id, origin, truth: truthOnly(source) })));

const setOf = computed(() => {
  const places = truths.value.map(({ id, origin, truth: { files } }) => {
    const file = files.find(({ role }) => role === "cloud") ?? files[0];
    // Files made here have paths too, which say nothing of a set.
    return { id, path: origin.kind === "sample" ? undefined : file?.path };
  });
  return setsOf(places);
});

const outcomes = computed(() => truths.value.map(({ id, truth }) => ({ id, outcome: counts.outcomes.value.get(truth.key) })));

const counted = computed<readonly CountedModel[]>(() =>
  outcomes.value.flatMap(({ id, outcome }) =>
    outcome?.kind === "answered" ? [{ id, set: setOf.value.get(id) ?? LOOSE, statistics: outcome.answer }] : [],
  ),
);

/** Models that could not be counted, with the reason. */
export const uncounted = computed<readonly { readonly id: string; readonly reason: string }[]>(() =>
  outcomes.value.flatMap(({ id, outcome }) => (outcome?.kind === "failed" ? [{ id, reason: outcome.message }] : [])),
);

/** Tries once more to count what could not be counted. */
export function countAgain(): void {
  counts.retry(truths.value.map(({ truth }) => truth));
}

export interface CountedSet {
  readonly name: string;
  readonly statistics: DatasetStatistics;
}

export interface Sums {
  /** What was summed up. */
  readonly models: readonly CountedModel[];
  readonly sets: readonly CountedSet[];
  readonly all: DatasetStatistics;
}

export const sums = signal<Sums | undefined>(undefined);

/** More sets than these would make a drawing each that nobody compares: then all are one. */
const MOST_SETS = 4;
const ALL = "all models";

const sumUp = latest(async (found: readonly CountedModel[]) => {
  const setCount = new Set(found.map(({ set }) => set)).size;
  const own = setCount > MOST_SETS ? found.map((model) => ({ ...model, set: ALL })) : found;
  const ask = (of: readonly CountedModel[]) => engine.run((api) => api.datasetStatistics(of.map(({ statistics }) => statistics)));
  const names = [...new Set(own.map(({ set }) => set))];
  const sets = names.map(async (name) => ({ name, statistics: await ask(own.filter(({ set }) => set === name)) }));
  sums.value = { models: own, sets: await Promise.all(sets), all: await ask(own) };
});

/** Counts the models on the page, and those that come, until the result is called. */
export function follow(): () => void {
  const ends = [
    effect(() => {
      const sources = truths.value.map(({ truth }) => truth);
      queueMicrotask(() => counts.ask(sources));
    }),
    effect(() => {
      sumUp(counted.value).catch((error: unknown) => notify(error instanceof Error ? error.message : String(error), "error"));
    }),
  ];
  return () => ends.forEach((end) => end());
}
