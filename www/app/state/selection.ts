// What the reader looks at: a model, a method, a primitive. Tables, view and charts all read and
// write these signals and so stay linked.

import { batch, computed, signal } from "@preact/signals";
import { modelById } from "./models";
import type { MethodReports } from "../../worker/protocol";

export type Side = "truth" | "prediction";

/** A primitive by its place in the list of its segmentation, counted from 0. */
export interface PrimitiveRef {
  readonly side: Side;
  readonly index: number;
}

export const selectedModel = signal<string | undefined>(undefined);
const chosenMethod = signal<string | undefined>(undefined);
export const selectedPrimitive = signal<PrimitiveRef | undefined>(undefined);
export const hoveredPrimitive = signal<PrimitiveRef | undefined>(undefined);

/** The chosen method where the model has it, else the model's first. */
export const selectedMethod = computed<string | undefined>(() => {
  const status = modelById(selectedModel.value)?.status;
  if (status?.kind !== "scored") return undefined;
  const { methods } = status.result.info;
  return methods.find((method) => method === chosenMethod.value) ?? methods[0];
});

/** The reports of what is selected, where it could be scored. */
export const selectedReports = computed<MethodReports | undefined>(() => {
  const status = modelById(selectedModel.value)?.status;
  if (status?.kind !== "scored") return undefined;
  return status.result.reports.find(({ method }) => method === selectedMethod.value);
});

export function selectModel(id: string | undefined, method?: string): void {
  batch(() => {
    if (id !== selectedModel.value || (method !== undefined && method !== selectedMethod.value)) {
      selectedPrimitive.value = undefined;
      hoveredPrimitive.value = undefined;
    }
    selectedModel.value = id;
    if (method !== undefined) chosenMethod.value = method;
  });
}

/** Selects a primitive, or takes the selection back when it is selected already. */
export function togglePrimitive(ref: PrimitiveRef): void {
  const current = selectedPrimitive.value;
  const same = current?.side === ref.side && current.index === ref.index;
  selectedPrimitive.value = same ? undefined : ref;
}
