// Each method's means over the models, asked of the engine whenever the scores change.

import { effect, signal } from "@preact/signals";
import { scoresOf } from "../../shared/formats/measures.mjs";
import { engine } from "../engine/client";
import type { MethodSummary, Protocol } from "../engine/contract";
import { latest } from "../engine/latest";
import { models, scoredRows } from "../state/models";
import { protocol } from "../state/settings";

export interface Means {
  readonly protocol: Protocol;
  readonly methods: readonly MethodSummary[];
}

/** Of the protocol that is on, once the engine has answered; nothing for a single model. */
export const means = signal<Means | undefined>(undefined);

/** Scores may come in faster than they are summed up: then only the last state of them is. */
const sumUp = latest(async (rules: Protocol | undefined) => {
  if (rules === undefined) {
    means.value = undefined;
    return;
  }
  const scores = scoresOf(scoredRows.peek().map(({ reports }) => reports[rules]));
  try {
    means.value = { protocol: rules, methods: await engine.run((api) => api.summarise(scores)) };
  } catch {
    // The rows stand without their means.
    means.value = undefined;
  }
});

/** Asks for the means whenever the scores change, until the result is called. */
export function followScores(): () => void {
  return effect(() => {
    const enough = models.value.length > 1 && scoredRows.value.length > 0;
    void sumUp(enough ? protocol.value : undefined);
  });
}
