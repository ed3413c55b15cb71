// Looking at the selected primitive alone, and putting primitives out of sight.

import { computed, signal } from "@preact/signals";
import { rivalMethod, selectedMethod, selectedModel, selectedPrimitive, type PrimitiveRef } from "../state/selection";
import { currentView } from "./current";
import { frame } from "./framing";

/** Whether everything but the selected primitive and its partner is out of sight. */
export const isolated = signal(false);

/** Where the places of primitives mean what they do: they mean something else in another model or submission. */
const where = computed(() => JSON.stringify([selectedModel.value, selectedMethod.value, rivalMethod.value]));
const putAside = signal<{ readonly where: string; readonly refs: readonly PrimitiveRef[] }>({ where: "", refs: [] });

/** Primitives put out of sight, with their partners. */
export const hidden = computed(() => (putAside.value.where === where.value ? putAside.value.refs : []));

export function toggleIsolated(): void {
  if (selectedPrimitive.value) isolated.value = !isolated.value;
}

export function hideSelected(): void {
  const ref = selectedPrimitive.value;
  if (!ref) return;
  putAside.value = { where: where.value, refs: [...hidden.value, ref] };
  selectedPrimitive.value = undefined;
}

export function showAll(): void {
  putAside.value = { where: "", refs: [] };
  isolated.value = false;
}

export function frameSelected(): void {
  const ref = selectedPrimitive.value;
  const view = currentView.value;
  if (view && !(ref && frame(view, ref))) view.fit();
}
