// The selected model, opened to be looked at.

import { effect, signal } from "@preact/signals";
import { engine } from "../engine/client";
import type { ModelScene } from "../../worker/protocol";
import { modelById } from "./models";
import { rivalMethod, selectedMethod, selectedModel } from "./selection";

export type SceneState =
  | { readonly kind: "none" }
  | { readonly kind: "loading" }
  | { readonly kind: "ready"; readonly scene: ModelScene }
  | { readonly kind: "failed"; readonly message: string };

export const scene = signal<SceneState>({ kind: "none" });

let controller = new AbortController();

/** Opens what is selected, now and later, until the result is called. */
export function openSelected(): () => void {
  return effect(reopen);
}

function reopen(): void {
  const entry = modelById(selectedModel.value);
  const method = selectedMethod.value;
  const rival = rivalMethod.value;
  const current = scene.peek();
  // Wait for the score: it tells the methods, and the worker then holds the model already.
  if (entry?.status.kind !== "scored") {
    controller.abort();
    scene.value = entry?.status.kind === "waiting" ? { kind: "loading" } : { kind: "none" };
    return;
  }
  const { source } = entry;
  const shown = current.kind === "ready" && current.scene.key === source.key ? current.scene : undefined;
  if (shown && shown.method === method && shown.rival?.method === rival) return;
  controller.abort();
  controller = new AbortController();
  void open(controller.signal);

  async function open(signal: AbortSignal): Promise<void> {
    // A model once shown stays while only the submissions change.
    if (!shown) scene.value = { kind: "loading" };
    try {
      const opened = await engine.run((api) => api.open(source, method, rival), { signal });
      if (!signal.aborted) scene.value = { kind: "ready", scene: opened };
    } catch (error) {
      if (signal.aborted) return;
      scene.value = { kind: "failed", message: error instanceof Error ? error.message : String(error) };
    }
  }
}
