// Fitting models with HT or PG: one job of the pool per model, each stoppable at any moment.

import { proxy } from "comlink";
import { batch, computed, signal, type Signal } from "@preact/signals";
import { engine } from "../engine/client";
import type { FitRequest, FittedModel, ModelSource } from "../../worker/protocol";
import { addSubmission, isMadeHere } from "./inbox";
import type { ModelEntry } from "./models";
import { notify } from "./notices";
import { selectedModel, selectModel } from "./selection";

export type FitState =
  | { readonly kind: "queued" }
  | { readonly kind: "running"; readonly stage: string; readonly fraction: number }
  | { readonly kind: "done"; readonly result: FittedModel }
  | { readonly kind: "stopped" }
  | { readonly kind: "failed"; readonly message: string };

/** One model of a run. Its state changes often, so it is a signal of its own. */
export interface Fit {
  readonly model: string;
  readonly state: Signal<FitState>;
  readonly stop: () => void;
}

export interface FitRun {
  readonly request: FitRequest;
  readonly fits: readonly Fit[];
  /** `performance.now()` when it began. */
  readonly since: number;
}

/** The run under way, or the last one. */
export const fitRun = signal<FitRun | undefined>(undefined);

/** What share of a fit's time each stage takes, roughly: finding surfaces is nearly all of it. */
const STAGES: readonly { readonly name: string; readonly share: number }[] = [
  { name: "prepare", share: 0.1 },
  { name: "find", share: 0.75 },
  { name: "prune", share: 0.05 },
  { name: "label", share: 0.05 },
  { name: "patches", share: 0.05 },
];

/** How much of a fit is done, 0 to 1. */
export function shareDone(state: FitState): number {
  if (state.kind === "queued") return 0;
  if (state.kind !== "running") return 1;
  const at = STAGES.findIndex(({ name }) => name === state.stage);
  const before = STAGES.slice(0, Math.max(0, at)).reduce((sum, { share }) => sum + share, 0);
  return before + (STAGES[at]?.share ?? 0) * state.fraction;
}

export interface FitProgress {
  readonly done: number;
  readonly total: number;
  /** Share of the whole run, 0 to 1. */
  readonly share: number;
  readonly since: number;
}

/** How far the run under way has come; undefined where there is none. */
export const fitProgress = computed<FitProgress | undefined>(() => {
  const run = fitRun.value;
  if (!run) return undefined;
  const states = run.fits.map(({ state }) => state.value);
  const done = states.filter(({ kind }) => kind !== "queued" && kind !== "running").length;
  const total = states.length;
  if (done === total) return undefined;
  return { done, total, share: states.reduce((sum, state) => sum + shareDone(state), 0) / total, since: run.since };
});

/** Submissions made here, by model and settings: fitting the same again replaces the first. */
const madeWith = new Map<string, string>();

/** Fits the models, unless a run is under way; resolves when all of them are done or stopped. */
export async function fitModels(entries: readonly ModelEntry[], request: FitRequest): Promise<void> {
  if (fitProgress.peek() || entries.length === 0) return;
  const jobs = entries.map((entry) => {
    const controller = new AbortController();
    const fit: Fit = {
      model: entry.id,
      state: signal<FitState>({ kind: "queued" }),
      stop: () => controller.abort(new DOMException("Stopped by the reader.", "AbortError")),
    };
    return { entry, fit, signal: controller.signal };
  });
  fitRun.value = { request, fits: jobs.map(({ fit }) => fit), since: performance.now() };
  await Promise.all(jobs.map(({ entry, fit, signal }) => perform(entry, fit, request, signal)));
  tellEnd();
}

/** Stops every fit under way. What is fitted stays. */
export function cancelFitting(): void {
  batch(() => fitRun.peek()?.fits.forEach(({ stop }) => stop()));
}

async function perform(entry: ModelEntry, fit: Fit, request: FitRequest, signal: AbortSignal): Promise<void> {
  const { id } = entry;
  const settings = JSON.stringify([id, request]);
  const earlier = madeWith.get(settings);
  // It may be gone, and a brought submission have its name.
  const replaced = earlier !== undefined && isMadeHere(id, earlier) ? earlier : undefined;
  const onStage = proxy((stage: string, fraction: number) => {
    const { kind } = fit.state.peek();
    // A message may be on its way while the reader stops the fit.
    if (kind === "queued" || kind === "running") fit.state.value = { kind: "running", stage, fraction };
  });
  const urgency = id === selectedModel.peek() ? "foreground" : "idle";
  try {
    const source = without(entry.source, replaced);
    const result = await engine.run((api) => api.fit(source, request, onStage), { signal, urgency });
    batch(() => {
      fit.state.value = { kind: "done", result };
      madeWith.set(settings, result.method);
      addSubmission(id, result.method, result.files, request);
      if (id === selectedModel.peek()) selectModel(id, result.method);
    });
  } catch (error) {
    const message = error instanceof Error ? error.message : String(error);
    fit.state.value = signal.aborted ? { kind: "stopped" } : { kind: "failed", message };
  }
}

/** The files of a model save those of one submission. */
function without(source: ModelSource, method: string | undefined): ModelSource {
  if (method === undefined) return source;
  const files = source.files.filter((file) => file.method !== method);
  return { ...source, key: `${source.key}\nwithout ${method}`, files };
}

function tellEnd(): void {
  const run = fitRun.peek();
  if (!run) return;
  const states = run.fits.map(({ state }) => state.peek());
  const count = (kind: FitState["kind"]) => states.filter((state) => state.kind === kind).length;
  const [only] = states.length === 1 ? states : [];
  const name = run.request.method.toUpperCase();
  if (only?.kind === "done") {
    const { primitives, seconds } = only.result;
    notify(`${name} found ${primitives} primitives in ${run.fits[0]?.model}, in ${seconds.toFixed(2)} s.`);
  } else if (only?.kind === "failed") {
    notify(`${run.fits[0]?.model} could not be fitted: ${only.message}`, "error");
  } else {
    const rest = [count("stopped") && `${count("stopped")} stopped`, count("failed") && `${count("failed")} failed`].filter(Boolean);
    notify(`${name} fitted ${count("done")} of ${states.length}${rest.length > 0 ? `; ${rest.join(", ")}` : ""}.`, count("failed") > 0 ? "error" : "info");
  }
}
