// Looking at the selected primitive alone, and putting primitives out of sight.

import { effect, signal } from "@preact/signals";
import type { PointView } from "../view/point-view";
import { frame } from "./framing";
import { rivalMethod, selectedMethod, selectedModel, selectedPrimitive, type PrimitiveRef } from "../state/selection";

/** The view on the page, once it is there. */
export const currentView = signal<PointView | undefined>(undefined);

/** Whether everything but the selected primitive and its partner is out of sight. */
export const isolated = signal(false);
/** Primitives put out of sight, with their partners. */
export const hidden = signal<readonly PrimitiveRef[]>([]);

effect(() => {
  // Places mean something else in another model or submission.
  void selectedModel.value;
  void selectedMethod.value;
  void rivalMethod.value;
  hidden.value = [];
});

export function toggleIsolated(): void {
  if (selectedPrimitive.value) isolated.value = !isolated.value;
}

export function hideSelected(): void {
  const ref = selectedPrimitive.value;
  if (!ref) return;
  hidden.value = [...hidden.value, ref];
  selectedPrimitive.value = undefined;
}

export function showAll(): void {
  hidden.value = [];
  isolated.value = false;
}

export function frameSelected(): void {
  const ref = selectedPrimitive.value;
  const view = currentView.value;
  if (view && !(ref && frame(view, ref))) view.fit();
}
