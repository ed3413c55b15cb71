// What a submission makes of each point, asked of the engine while the colours show it.

import { batch, effect, signal } from "@preact/signals";
import { engine } from "../engine/client";
import { latest } from "../engine/latest";
import { modelById } from "../state/models";
import { scene } from "../state/scene";
import { selectedModel, selectedPrimitive } from "../state/selection";
import type { ModelSource } from "../../worker/protocol";
import { partnersOf, type Outcomes, type Partners } from "./colouring";
import { colourMode } from "./display";
import { reports } from "./reports";

/** The engine's last answer; those of another model have another length. */
export const outcomes = signal<Outcomes>({});

/** Starts keeping the outcomes in step; the result ends it. */
export function linkOutcomes(): () => void {
  return effect(() => {
    const wanted = wantedNow();
    void ask(wanted);
  });
}

interface Wanted {
  readonly source: ModelSource;
  readonly submissions: Readonly<Record<"prediction" | "rival", string | undefined>>;
  /** Of one true primitive and its matches; absent where the paper's figure is shown. */
  readonly partners: Partners | undefined;
}

function wantedNow(): Wanted | undefined {
  const mode = colourMode.value;
  const state = scene.value;
  const selected = selectedPrimitive.value;
  const source = modelById(selectedModel.value)?.source;
  if (state.kind !== "ready" || source?.key !== state.scene.key || !state.scene.truth) return undefined;
  const { method, rival } = state.scene;
  const known = reports.value;
  const submissions = {
    prediction: known.prediction && method,
    rival: known.rival && rival?.method,
  };
  if (mode === "figure") return { source, submissions, partners: undefined };
  return mode === "outcome" && selected ? { source, submissions, partners: partnersOf(known, selected) } : undefined;
}

/** Selections may change faster than they are answered. */
const ask = latest(async (wanted: Wanted | undefined) => {
  if (!wanted) {
    outcomes.value = {};
    return;
  }
  const { source, submissions, partners } = wanted;
  const of = async (side: "prediction" | "rival") => {
    const method = submissions[side];
    if (method === undefined) return undefined;
    return engine.run((api) => (partners ? api.outcomes(source, method, partners.truth, partners[side]) : api.figure(source, method)));
  };
  try {
    const [prediction, rival] = await Promise.all([of("prediction"), of("rival")]);
    batch(() => (outcomes.value = { ...(prediction && { prediction }), ...(rival && { rival }) }));
  } catch {
    // Points without an outcome look like points of no primitive.
    outcomes.value = {};
  }
});
