// Each method's means over the models, asked of the engine whenever the scores change.

import { effect, signal } from "@preact/signals";
import { engine } from "../engine/client";
import type { Distribution, Measure, Protocol } from "../engine/contract";
import { MEASURES } from "../measures/measures";
import { methods, models, scoredRows } from "../state/models";
import { protocol } from "../state/settings";

export interface MethodMeans {
  readonly method: string;
  /** How many models the method has been scored on. */
  readonly models: number;
  /** Absent for a measure that no model has. */
  readonly over: Readonly<Partial<Record<Measure, Distribution>>>;
}

export interface Means {
  readonly protocol: Protocol;
  readonly methods: readonly MethodMeans[];
}

/** Of the protocol that is on, once the engine has answered; nothing for a single model. */
export const means = signal<Means | undefined>(undefined);

let latest = 0;

effect(() => {
  const rows = scoredRows.value;
  const rules = protocol.value;
  const names = methods.value;
  const request = ++latest;
  if (models.value.length < 2 || rows.length === 0) {
    means.value = undefined;
    return;
  }
  const reports = names.map((name) => rows.flatMap((row) => (row.reports.method === name ? [row.reports[rules]] : [])));
  const lists = reports.flatMap((own) =>
    MEASURES.map((measure) => Float64Array.from(own, ({ mean }) => mean[measure] ?? NaN)),
  );
  engine
    .run((api) => api.distributions(lists))
    .then((spread) => {
      if (request !== latest) return;
      const of = (at: number) => MEASURES.map((measure, m) => [measure, spread[at * MEASURES.length + m]] as const);
      means.value = {
        protocol: rules,
        methods: names.map((method, at) => ({
          method,
          models: reports[at]?.length ?? 0,
          over: Object.fromEntries(of(at).filter(([, distribution]) => distribution !== undefined)),
        })),
      };
    })
    .catch(() => {
      // The rows stand without their means.
      if (request === latest) means.value = undefined;
    });
});
