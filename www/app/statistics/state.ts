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

const setOf = computed(() => {
  const places = models.value.map(({ id, source, origin }) => {
    const own = source.files.filter(({ method }) => method === undefined);
    const file = own.find(({ role }) => role === "cloud") ?? own[0];
    // Files made here have paths too, which say nothing of a set.
    return { id, path: origin.kind === "sample" ? undefined : file?.path };
  });
  return setsOf(places);
});

export const counted = computed<readonly CountedModel[]>(() =>
  models.value.flatMap(({ id, source }) => {
    const outcome = counts.outcomes.value.get(truthOnly(source).key);
    return outcome?.kind === "answered" ? [{ id, set: setOf.value.get(id) ?? LOOSE, statistics: outcome.answer }] : [];
  }),
);

/** Models that could not be counted, with the reason. */
export const uncounted = computed<readonly { readonly id: string; readonly reason: string }[]>(() =>
  models.value.flatMap(({ id, source }) => {
    const outcome = counts.outcomes.value.get(truthOnly(source).key);
    return outcome?.kind === "failed" ? [{ id, reason: outcome.message }] : [];
  }),
);

/** Tries once more to count what could not be counted. */
export function countAgain(): void {
  counts.retry(models.value.map(({ source }) => truthOnly(source)));
}

export interface CountedSet {
  readonly name: string;
  readonly statistics: DatasetStatistics;
}

/** More sets than these would make a drawing each that nobody compares: then all are drawn as one. */
const MOST_SETS = 4;
export const ALL = "all models";

/** The sums, set by set unless there are too many to be drawn, and those of all models. */
export const sums = signal<{ readonly sets: readonly CountedSet[]; readonly all: DatasetStatistics } | undefined>(undefined);

const sumUp = latest(async (all: readonly CountedModel[]) => {
  const ask = (of: readonly CountedModel[]) => engine.run((api) => api.datasetStatistics(of.map(({ statistics }) => statistics)));
  const names = [...new Set(all.map(({ set }) => set))];
  const whole = await ask(all);
  const sets = names.map(async (name) => ({ name, statistics: await ask(all.filter(({ set }) => set === name)) }));
  sums.value = { sets: names.length > MOST_SETS ? [{ name: ALL, statistics: whole }] : await Promise.all(sets), all: whole };
});

/** Counts the models on the page, and those that come, until the result is called. */
export function follow(): () => void {
  const ends = [
    effect(() => {
      const sources = models.value.map(({ source }) => truthOnly(source));
      queueMicrotask(() => counts.ask(sources));
    }),
    effect(() => {
      sumUp(counted.value).catch((error: unknown) => notify(error instanceof Error ? error.message : String(error), "error"));
    }),
  ];
  return () => ends.forEach((end) => end());
}
