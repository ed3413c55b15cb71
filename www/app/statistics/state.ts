// The models on the page in numbers, one by one and set by set.

import { computed, effect, signal } from "@preact/signals";
import { engine } from "../engine/client";
import type { DatasetStatistics, ModelStatistics } from "../engine/contract";
import { latest } from "../engine/latest";
import { survey } from "../engine/survey";
import { models } from "../state/models";
import { notify } from "../state/notices";
import { truthOnly } from "../state/content";
import { setsOf } from "./sets";

export const counts = survey<ModelStatistics>((api, source) => api.statistics(source));

export interface CountedModel {
  readonly id: string;
  readonly set: string;
  readonly statistics: ModelStatistics;
}

export const counted = computed<readonly CountedModel[]>(() => {
  const places = models.value.map(({ id, source, origin }) => {
    const own = source.files.filter(({ method }) => method === undefined);
    const file = own.find(({ role }) => role === "cloud") ?? own[0];
    // Files made here have paths too, which say nothing of a set.
    return { id, path: origin.kind === "files" ? file?.path : undefined };
  });
  const setOf = new Map([...setsOf(places)].flatMap(([set, ids]) => ids.map((id) => [id, set] as const)));
  return models.value.flatMap(({ id, source }) => {
    const outcome = counts.outcomes.value.get(truthOnly(source).key);
    return outcome?.kind === "answered" ? [{ id, set: setOf.get(id) ?? "", statistics: outcome.answer }] : [];
  });
});

export interface CountedSet {
  readonly name: string;
  readonly statistics: DatasetStatistics;
}

/** The sums, set by set, and those of all models. */
export const sums = signal<{ readonly sets: readonly CountedSet[]; readonly all: DatasetStatistics } | undefined>(undefined);

const sumUp = latest(async (all: readonly CountedModel[]) => {
  const ask = (of: readonly CountedModel[]) => engine.run((api) => api.datasetStatistics(of.map(({ statistics }) => statistics)));
  const names = [...new Set(all.map(({ set }) => set))];
  const sets = names.map(async (name) => ({ name, statistics: await ask(all.filter(({ set }) => set === name)) }));
  sums.value = { sets: await Promise.all(sets), all: await ask(all) };
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
