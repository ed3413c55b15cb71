// Scoring many models: spread over the pool, with progress, and stoppable at any moment.

import { batch, signal } from "@preact/signals";
import { engine } from "../engine/client";
import { selectedModel } from "./selection";
import { models, setStatus, type ModelEntry } from "./models";

export interface Progress {
  readonly done: number;
  readonly total: number;
  /** `performance.now()` when the batch began. */
  readonly since: number;
}

/** The batch under way, if there is one. */
export const progress = signal<Progress | undefined>(undefined);

let controller = new AbortController();
/** Models queued or being scored, by the key of their files. */
const underWay = new Set<string>();

/** Scores the models not yet under way; what the reader is looking at comes first. */
export function scoreAll(entries: readonly ModelEntry[]): void {
  const fresh = entries.filter(({ source }) => !underWay.has(source.key));
  if (fresh.length === 0) return;
  const current = progress.value;
  progress.value = current
    ? { ...current, total: current.total + fresh.length }
    : { done: 0, total: fresh.length, since: performance.now() };
  for (const entry of fresh) void score(entry, controller.signal);
}

/** Stops everything under way. What is scored stays. */
export function cancelScoring(): void {
  controller.abort();
  controller = new AbortController();
}

/** Scores what had been stopped. */
export function resumeScoring(): void {
  models.value = models.value.map((entry) =>
    entry.status.kind === "stopped" ? { ...entry, status: { kind: "waiting" } } : entry,
  );
  scoreAll(models.value.filter(({ status }) => status.kind === "waiting"));
}

async function score(entry: ModelEntry, signal: AbortSignal): Promise<void> {
  const { id, source } = entry;
  underWay.add(source.key);
  const urgency = id === selectedModel.value ? "foreground" : "background";
  try {
    const result = await engine.run((api) => api.score(source), { signal, urgency });
    setStatus(id, source.key, { kind: "scored", result });
  } catch (error) {
    const message = error instanceof Error ? error.message : String(error);
    setStatus(id, source.key, signal.aborted ? { kind: "stopped" } : { kind: "failed", message });
  }
  underWay.delete(source.key);
  batch(() => {
    const current = progress.value;
    if (!current) return;
    const done = current.done + 1;
    progress.value = done >= current.total ? undefined : { ...current, done };
  });
}
