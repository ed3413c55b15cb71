// One question about every model: spread over the pool, with progress, stoppable, and asked once
// of the same content.

import type * as Comlink from "comlink";
import { batch, computed, signal, type ReadonlySignal } from "@preact/signals";
import type { EngineWorker, ModelSource } from "../../worker/protocol";
import { engine } from "./client";
import { paced } from "./pace";

export type Outcome<Answer> =
  | { readonly kind: "answered"; readonly answer: Answer }
  | { readonly kind: "failed"; readonly message: string };

export interface Survey<Answer> {
  /** By the key of the content. */
  readonly outcomes: ReadonlySignal<ReadonlyMap<string, Outcome<Answer>>>;
  /** What is under way, if anything is. */
  readonly progress: ReadonlySignal<{ readonly done: number; readonly total: number } | undefined>;
  /** Asks about those not asked about yet. */
  readonly ask: (sources: readonly ModelSource[]) => void;
  /** Asks once more about those that failed. */
  readonly retry: (sources: readonly ModelSource[]) => void;
  /** Gives up what is under way; answers stay. */
  readonly stop: () => void;
}

export function survey<Answer>(
  question: (api: Comlink.Remote<EngineWorker>, source: ModelSource) => Promise<Answer>,
): Survey<Answer> {
  const outcomes = signal<ReadonlyMap<string, Outcome<Answer>>>(new Map());
  const asked = signal(0);
  const done = signal(0);
  const underWay = new Set<string>();
  let controller = new AbortController();
  let arrived: [string, Outcome<Answer> | undefined][] = [];

  const settle = (key: string, outcome: Outcome<Answer> | undefined) => {
    arrived.push([key, outcome]);
    show();
  };

  const show = paced(() =>
    batch(() => {
      const all = new Map(outcomes.value);
      for (const [key, outcome] of arrived) {
        underWay.delete(key);
        if (outcome) all.set(key, outcome);
      }
      outcomes.value = all;
      done.value += arrived.length;
      arrived = [];
      if (done.value >= asked.value) asked.value = done.value = 0;
    }),
  );

  const askOf = async (source: ModelSource, signal: AbortSignal) => {
    underWay.add(source.key);
    try {
      const answer = await engine.run((api) => question(api, source), { signal, urgency: "background" });
      settle(source.key, { kind: "answered", answer });
    } catch (error) {
      const message = error instanceof Error ? error.message : String(error);
      settle(source.key, signal.aborted ? undefined : { kind: "failed", message });
    }
  };

  const ask = (sources: readonly ModelSource[]) => {
    const fresh = sources.filter(({ key }) => !underWay.has(key) && !outcomes.peek().has(key));
    if (fresh.length === 0) return;
    asked.value += fresh.length;
    for (const source of fresh) void askOf(source, controller.signal);
  };

  return {
    outcomes,
    progress: computed(() => (asked.value > 0 ? { done: done.value, total: asked.value } : undefined)),
    ask,
    retry(sources) {
      outcomes.value = new Map([...outcomes.peek()].filter(([, { kind }]) => kind !== "failed"));
      ask(sources);
    },
    stop() {
      controller.abort();
      controller = new AbortController();
    },
  };
}
