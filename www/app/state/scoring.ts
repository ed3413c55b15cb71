// Scoring many models: spread over the pool, with progress, and stoppable at any moment.

import * as Comlink from "comlink";
import { batch, effect, signal, untracked } from "@preact/signals";
import { LONG_FILE_BYTES } from "../../worker/protocol";
import { engine } from "../engine/client";
import { paced } from "../engine/pace";
import { selectedModel } from "./selection";
import { awaken, modelById, models, setStatuses, type ModelEntry, type Status } from "./models";

export interface Progress {
  readonly done: number;
  readonly total: number;
  /** `performance.now()` when the batch began. */
  readonly since: number;
}

/** The batch under way, if there is one. */
export const progress = signal<Progress | undefined>(undefined);

/** The long file that is being read, and how much of it is, 0 to 1. */
export const reading = signal<{ readonly path: string; readonly share: number } | undefined>(undefined);

let controller = new AbortController();
/** Contents that are queued, being scored, or scored and not shown yet, by their keys. */
const underWay = new Set<string>();
/** Results that have come since the page was last told. */
let arrived: (readonly [key: string, status: Status])[] = [];

/** Scores every model that waits for it, now and later, until the result is called. What the reader looks at comes first. */
export function scoreWaiting(): () => void {
  const ends = [
    effect(() => {
      const waiting = models.value.filter(({ status, source }) => status.kind === "waiting" && !underWay.has(source.key));
      if (waiting.length > 0) untracked(() => begin(waiting));
    }),
    effect(() => {
      const entry = modelById(selectedModel.value);
      if (entry?.status.kind === "waiting") engine.hasten(entry.source.key);
    }),
  ];
  return () => ends.forEach((end) => end());
}

/** Stops everything under way. What is scored stays. */
export function cancelScoring(): void {
  controller.abort();
  controller = new AbortController();
}

/** Scores what had been stopped. */
export function resumeScoring(): void {
  awaken();
}

function begin(entries: readonly ModelEntry[]): void {
  const current = progress.value;
  progress.value = current
    ? { ...current, total: current.total + entries.length }
    : { done: 0, total: entries.length, since: performance.now() };
  for (const entry of entries) void score(entry, controller.signal);
}

async function score({ id, source }: ModelEntry, signal: AbortSignal): Promise<void> {
  underWay.add(source.key);
  const urgency = id === selectedModel.peek() ? "foreground" : "background";
  let status: Status;
  try {
    // Each word of progress takes a channel of its own: of short files there is none.
    const onRead = source.files.some(({ data }) => data.size > LONG_FILE_BYTES) ? Comlink.proxy(tellReading) : undefined;
    const result = await engine.run((api) => api.score(source, onRead), { signal, urgency, name: source.key });
    status = { kind: "scored", result };
  } catch (error) {
    const message = error instanceof Error ? error.message : String(error);
    status = signal.aborted ? { kind: "stopped" } : { kind: "failed", message };
  }
  reading.value = undefined;
  arrived.push([source.key, status]);
  show();
}

function tellReading(path: string, share: number): void {
  reading.value = { path, share };
}

const show = paced(() => {
  const news = arrived;
  arrived = [];
  for (const [key] of news) underWay.delete(key);
  batch(() => {
    setStatuses(news);
    const current = progress.value;
    if (!current) return;
    const done = current.done + news.length;
    progress.value = done >= current.total ? undefined : { ...current, done };
  });
});
