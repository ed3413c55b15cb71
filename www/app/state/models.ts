// The models on the page: which files they are made of and what scoring them gave.

import { computed, signal } from "@preact/signals";
import type { SampleOptions } from "../engine/contract";
import type { PublicModel } from "../public/catalogue";
import type { MethodReports, ModelSource, ScoredModel } from "../../worker/protocol";

/** Where a model came from; a sample can be made again, a public model fetched again, from this alone. */
export type Origin =
  | { readonly kind: "files" }
  | { readonly kind: "public"; readonly model: PublicModel }
  | { readonly kind: "sample"; readonly part: string; readonly options: SampleOptions };

export type Status =
  | { readonly kind: "waiting" }
  | { readonly kind: "scored"; readonly result: ScoredModel }
  | { readonly kind: "stopped" }
  | { readonly kind: "failed"; readonly message: string };

export interface ModelEntry {
  /** Unique on the page; the model's name. */
  readonly id: string;
  readonly number: number | undefined;
  readonly origin: Origin;
  readonly source: ModelSource;
  readonly status: Status;
}

/** In the engine's order: by number, then by name. Never in order of arrival. */
export const models = signal<readonly ModelEntry[]>([]);

export function modelById(id: string | undefined): ModelEntry | undefined {
  return models.value.find((entry) => entry.id === id);
}

/** One scored method of one model: a row of the summary. */
export interface ScoredRow {
  readonly key: string;
  readonly entry: ModelEntry;
  readonly reports: MethodReports;
}

export const scoredRows = computed<readonly ScoredRow[]>(() =>
  models.value.flatMap((entry) =>
    entry.status.kind === "scored"
      ? entry.status.result.reports.map((reports) => ({ key: `${entry.id} ${reports.method}`, entry, reports }))
      : [],
  ),
);

export const methods = computed<readonly string[]>(() => [
  ...new Set(scoredRows.value.map(({ reports }) => reports.method)),
]);

let pending = new Map<string, { key: string; status: Status }>();

/**
 * Notes a model's new status. Many results may come in a burst, so they reach the page together,
 * at most once per frame; one that belongs to files replaced meanwhile is dropped.
 */
export function setStatus(id: string, key: string, status: Status): void {
  if (pending.size === 0) setTimeout(flush, 16);
  pending.set(id, { key, status });
}

function flush(): void {
  const updates = pending;
  pending = new Map();
  models.value = models.value.map((entry) => {
    const update = updates.get(entry.id);
    return update && update.key === entry.source.key ? { ...entry, status: update.status } : entry;
  });
}
