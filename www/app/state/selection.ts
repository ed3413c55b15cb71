// What the reader looks at: a model, a method, a primitive. Tables, view and charts all read and
// write these signals and so stay linked.

import { batch, computed, effect, signal } from "@preact/signals";
import { contents } from "./contents";
import { modelById } from "./models";
import type { MethodReports } from "../../worker/protocol";

/** The ground truth, the selected submission, or the one that is set beside it. */
export type Side = "truth" | "prediction" | "rival";

/** A primitive by its place in the list of its segmentation, counted from 0. */
export interface PrimitiveRef {
  readonly side: Side;
  readonly index: number;
}

const chosenModel = signal<string | undefined>(undefined);
const chosenMethod = signal<string | undefined>(undefined);
export const selectedPrimitive = signal<PrimitiveRef | undefined>(undefined);
export const hoveredPrimitive = signal<PrimitiveRef | undefined>(undefined);

/** The chosen model while it is on the page, else the first. */
export const selectedModel = computed<string | undefined>(() => {
  const chosen = contents.value.find(({ id }) => id === chosenModel.value) ?? contents.value[0];
  return chosen?.id;
});

/** What is selected stays so when others come before it, until the result is called. With a model that goes, so does its primitive. */
export function keepSelection(): () => void {
  return effect(() => {
    const selected = selectedModel.value;
    if (selected !== chosenModel.peek()) select(selected);
  });
}

/** The chosen method where the model has it, else the model's first. */
export const selectedMethod = computed<string | undefined>(() => {
  const status = modelById(selectedModel.value)?.status;
  if (status?.kind !== "scored") return undefined;
  const { methods } = status.result.info;
  return methods.find((method) => method === chosenMethod.value) ?? methods[0];
});

/** A submission to be shown in the left view; the ground truth where there is none. */
const leftMethod = signal<string | undefined>(undefined);
/** Whether the right view shows the ground truth in place of the selected submission. */
export const rightIsTruth = signal(false);

/** What the left view is to show: a submission that the model has, else its ground truth. */
export const leftShows = computed<string | undefined>(() => {
  const status = modelById(selectedModel.value)?.status;
  if (status?.kind !== "scored") return undefined;
  const { methods, hasTruth } = status.result.info;
  const chosen = methods.find((method) => method === leftMethod.value);
  // Without a truth there is nothing else to set beside the selected submission.
  return chosen ?? (hasTruth ? undefined : methods.find((method) => method !== selectedMethod.value));
});

/** The submission set beside the selected one. */
export const rivalMethod = computed(() => (leftShows.value === selectedMethod.value ? undefined : leftShows.value));

/** Shows a submission in the left view, or the ground truth. */
export function showLeft(method: string | undefined): void {
  batch(() => {
    if (selectedPrimitive.value?.side === "rival") selectedPrimitive.value = undefined;
    if (hoveredPrimitive.value?.side === "rival") hoveredPrimitive.value = undefined;
    leftMethod.value = method;
  });
}

/** The reports of what is selected, where it could be scored. */
export const selectedReports = computed(() => reportsOf(selectedMethod.value));
/** The reports of what is set beside it. */
export const rivalReports = computed(() => reportsOf(rivalMethod.value));

function reportsOf(wanted: string | undefined): MethodReports | undefined {
  const status = modelById(selectedModel.value)?.status;
  if (status?.kind !== "scored") return undefined;
  return status.result.reports.find(({ method }) => method === wanted);
}

export function selectModel(id: string | undefined, method?: string): void {
  batch(() => {
    if (id !== selectedModel.value || (method !== undefined && method !== selectedMethod.value)) select(id);
    // Whoever chooses a submission wants to see it.
    if (method !== undefined && method !== selectedMethod.value) rightIsTruth.value = false;
    chosenModel.value = id;
    if (method !== undefined) chosenMethod.value = method;
  });
}

/** Chooses a model; a primitive of what was selected before means nothing any more. */
function select(id: string | undefined): void {
  batch(() => {
    selectedPrimitive.value = undefined;
    hoveredPrimitive.value = undefined;
    chosenModel.value = id;
  });
}

/** Selects a primitive, or takes the selection back when it is selected already. */
export function togglePrimitive(ref: PrimitiveRef): void {
  const current = selectedPrimitive.value;
  const same = current?.side === ref.side && current.index === ref.index;
  selectedPrimitive.value = same ? undefined : ref;
}
