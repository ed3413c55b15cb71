// The models on the page: which files they are made of and what scoring them gave.

import { computed, signal } from "@preact/signals";
import type { MethodReports, ScoredModel } from "../../worker/protocol";
import { contents, type Content } from "./contents";

export type Status =
  | { readonly kind: "waiting" }
  | { readonly kind: "scored"; readonly result: ScoredModel }
  | { readonly kind: "stopped" }
  | { readonly kind: "failed"; readonly message: string };

export interface ModelEntry extends Content {
  readonly status: Status;
}

/** By the key of the content it is about. */
const statuses = signal<ReadonlyMap<string, Status>>(new Map());

const WAITING: Status = { kind: "waiting" };

const entries = new WeakMap<Content, ModelEntry>();

export const models = computed<readonly ModelEntry[]>(() =>
  contents.value.map((content) => {
    const status = statuses.value.get(content.source.key) ?? WAITING;
    let entry = entries.get(content);
    if (entry?.status !== status) {
      entry = { ...content, status };
      entries.set(content, entry);
    }
    return entry;
  }),
);

const byId = computed(() => new Map(models.value.map((entry) => [entry.id, entry])));

export function modelById(id: string | undefined): ModelEntry | undefined {
  return id === undefined ? undefined : byId.value.get(id);
}

/** How many points its cloud has; undefined while that is not read. */
export function pointsOf(entry: ModelEntry | undefined): number | undefined {
  return entry?.status.kind === "scored" ? entry.status.result.info.points : undefined;
}

/** Whether the engine fitted the surfaces of a method, or of the truth, to segments that came without. */
export function isFitted({ status }: ModelEntry, method: string | undefined): boolean {
  if (status.kind !== "scored") return false;
  const { fitted, truthFitted } = status.result.info;
  return method === undefined ? truthFitted : fitted.includes(method);
}

/** One scored method of one model: a row of the summary. */
export interface ScoredRow {
  readonly key: string;
  readonly entry: ModelEntry;
  readonly reports: MethodReports;
}

const rowsOf = new WeakMap<ModelEntry, readonly ScoredRow[]>();

export const scoredRows = computed<readonly ScoredRow[]>(() =>
  models.value.flatMap((entry) => {
    let rows = rowsOf.get(entry);
    if (!rows) {
      const { status, id } = entry;
      rows = status.kind === "scored" ? status.result.reports.map((reports) => ({ key: `${id} ${reports.method}`, entry, reports })) : [];
      rowsOf.set(entry, rows);
    }
    return rows;
  }),
);

export const methods = computed<readonly string[]>(() => [
  ...new Set(scoredRows.value.map(({ reports }) => reports.method)),
]);

/** Notes new statuses, by the keys of contents. Those of contents that are gone are forgotten. */
export function setStatuses(news: Iterable<readonly [key: string, status: Status]>): void {
  const all = new Map([...statuses.value, ...news]);
  const present = new Set(contents.value.map(({ source }) => source.key));
  for (const key of all.keys()) if (!present.has(key)) all.delete(key);
  statuses.value = all;
}

/** What was stopped waits again. */
export function awaken(): void {
  statuses.value = new Map([...statuses.value].filter(([, { kind }]) => kind !== "stopped"));
}
