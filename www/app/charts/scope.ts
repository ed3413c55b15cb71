// What the charts are about: all models or the selected one, the selected method or all.

import { batch, computed, signal } from "@preact/signals";
import type { Report, TruthReport } from "../engine/contract";
import { methods, scoredRows } from "../state/models";
import { selectedMethod, selectedModel, selectedPrimitive, selectModel, type PrimitiveRef } from "../state/selection";
import { protocol } from "../state/settings";
import { segmentColour } from "../view/palette";

export type Scope = "all" | "one";

export const scope = signal<Scope>("all");

/** A report, with the name that the model has on the page. */
export interface Scored {
  readonly model: string;
  readonly method: string;
  readonly report: Report;
}

export const scoredInScope = computed<readonly Scored[]>(() =>
  scoredRows.value
    .filter(({ entry }) => scope.value === "all" || entry.id === selectedModel.value)
    .map(({ entry, reports }) => ({ model: entry.id, method: reports.method, report: reports[protocol.value] })),
);

/** The method that is charted where there can be only one. */
export const chartedMethod = computed(() => selectedMethod.value ?? methods.value[0]);

export const ofChartedMethod = computed(() => scoredInScope.value.filter(({ method }) => method === chartedMethod.value));

/** A true primitive as a method found it. */
export interface TruePrimitive {
  readonly model: string;
  readonly method: string;
  /** Place in the list of the truth. */
  readonly place: number;
  readonly report: TruthReport;
}

export const truePrimitives = computed<readonly TruePrimitive[]>(() =>
  ofChartedMethod.value.flatMap(({ model, method, report }) =>
    report.primitives.map((own, place) => ({ model, method, place, report: own })),
  ),
);

/** In words, for titles: `all 3 models`, `bracket`. */
export const scopeText = computed(() => {
  const names = new Set(scoredInScope.value.map(({ model }) => model));
  const [only] = names;
  return names.size === 1 ? String(only) : `${names.size} models`;
});

export function goTo(model: string, method: string, primitive?: PrimitiveRef): void {
  batch(() => {
    selectModel(model, method);
    selectedPrimitive.value = primitive;
  });
}

export function isSelected({ model, method }: { model: string; method: string }): boolean {
  return model === selectedModel.value && method === selectedMethod.value;
}

export function methodColour(method: string): string {
  return segmentColour(methods.value.indexOf(method));
}
