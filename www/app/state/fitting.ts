// Fitting models: one job of the pool per model, each stoppable at any moment.

import { proxy } from "comlink";
import { batch, computed, signal, type Signal } from "@preact/signals";
import { FITTERS } from "../../generated/declared/fitters.js";
import { STAGES } from "../../generated/declared/stages.js";
import { engine } from "../engine/client";
import type { FitRequest, FittedModel } from "../../worker/protocol";
import { plural } from "../ui/format";
import { without } from "./content";
import { addSubmission } from "./contents";
import { isMadeHere } from "./made";
import { modelById, pointsOf } from "./models";
import { notify } from "./notices";
import { selectedModel, selectModel } from "./selection";

export type FitState =
  | { readonly kind: "queued" }
  | { readonly kind: "running"; readonly stage: string; readonly fraction: number }
  | { readonly kind: "done"; readonly result: FittedModel }
  | { readonly kind: "stopped" }
  | { readonly kind: "failed"; readonly message: string };

/** One fit of a run. Its state changes often, so it is a signal of its own. */
export interface Fit {
  readonly model: string;
  readonly request: FitRequest;
  readonly state: Signal<FitState>;
  readonly stop: () => void;
}

export interface FitRun {
  readonly fits: readonly Fit[];
  /** `performance.now()` when it began. */
  readonly since: number;
  /** Ends all fits not yet done. */
  readonly stop: () => void;
}

/** A model, by its name, and how to fit it. */
export interface FitJob {
  readonly model: string;
  readonly request: FitRequest;
}

/** What became of the fits of a run. */
export interface FitTally {
  readonly done: number;
  readonly stopped: number;
  readonly failed: number;
}

export interface FitOptions {
  /** Stops the run. */
  readonly signal?: AbortSignal;
  /** Shows no submission it makes, and leaves it to the caller to tell the end. */
  readonly quiet?: boolean;
}

/** What a run fits with: `HT`, `PG`, or `HT and PG` where it repeats what a link claims. */
export function methodsOf({ fits }: FitRun): string {
  return [...new Set(fits.map(({ request }) => titleOf(request.method)))].join(" and ");
}

/** What submissions by a fitter are called. */
export function titleOf(method: FitRequest["method"]): string {
  return FITTERS.find(({ name }) => name === method)?.title ?? method;
}

/** The run under way, or the last one. */
export const fitRun = signal<FitRun | undefined>(undefined);

/** How long a fit took. */
export interface FitDone {
  readonly method: FitRequest["method"];
  readonly model: string;
  readonly points: number;
  /** Of fitting, without reading. */
  readonly seconds: number;
}

/** The fits done since the page was opened that tell how long another may take, the last of them last. */
export const fitsDone = signal<readonly FitDone[]>([]);
const MOST_REMEMBERED = 100;

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

/**
 * Does the fits, in the order of the jobs; nothing where a run is under way. Resolves when all of them are done or
 * stopped. Those of one model are done one after the other, each knowing what the earlier ones are called.
 */
export async function fitModels(jobs: readonly FitJob[], { signal: stopped, quiet = false }: FitOptions = {}): Promise<FitRun | undefined> {
  if (fitProgress.peek()) return undefined;
  const begun = jobs.map(({ model, request }) => {
    const controller = new AbortController();
    const fit: Fit = {
      model,
      request,
      state: signal<FitState>({ kind: "queued" }),
      stop: () => controller.abort(),
    };
    return { fit, signal: controller.signal };
  });
  const fits = begun.map(({ fit }) => fit);
  const stop = () => batch(() => fits.forEach((fit) => fit.stop()));
  if (stopped?.aborted) stop();
  stopped?.addEventListener("abort", stop, { once: true });
  const run: FitRun = { fits, since: performance.now(), stop };
  fitRun.value = run;
  const lanes = new Map<string, Promise<void>>();
  for (const { fit, signal } of begun) {
    const earlier = lanes.get(fit.model) ?? Promise.resolve();
    lanes.set(fit.model, earlier.then(() => perform(fit, signal, quiet)));
  }
  await Promise.all(lanes.values());
  stopped?.removeEventListener("abort", stop);
  if (!quiet) tellEnd(run);
  return run;
}

/** Stops every fit under way. What is fitted stays. */
export function cancelFitting(): void {
  fitRun.peek()?.stop();
}

async function perform(fit: Fit, signal: AbortSignal, quiet: boolean): Promise<void> {
  const { model: id, request } = fit;
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
    const known = modelById(id)?.source;
    if (!known) throw new Error(`${id} is no longer on the page.`);
    const source = replaced === undefined ? known : without(known, replaced);
    const result = await engine.run((api) => api.fit(source, request, onStage), { signal, urgency });
    batch(() => {
      fit.state.value = { kind: "done", result };
      remember(id, request, result.seconds);
      madeWith.set(settings, result.method);
      addSubmission(id, result.method, result.files, request);
      if (!quiet && id === selectedModel.peek()) selectModel(id, result.method);
    });
  } catch (error) {
    const message = error instanceof Error ? error.message : String(error);
    fit.state.value = signal.aborted ? { kind: "stopped" } : { kind: "failed", message };
  }
}

function remember(model: string, { method, parameters }: FitRequest, seconds: number): void {
  const points = pointsOf(modelById(model));
  // Where all points are labelled by a fit of some, its time tells little of another's.
  if (points === undefined || points > (parameters["subsample"] || Infinity)) return;
  fitsDone.value = [...fitsDone.peek(), { method, model, points, seconds }].slice(-MOST_REMEMBERED);
}

export function tallyOf({ fits }: FitRun): FitTally {
  const count = (kind: FitState["kind"]) => fits.filter(({ state }) => state.peek().kind === kind).length;
  return { done: count("done"), stopped: count("stopped"), failed: count("failed") };
}

/** Says how a run ended: `what`, and of how many fits nothing came. */
export function tellTally(what: string, { stopped, failed }: FitTally): void {
  const rest = [stopped > 0 && `${stopped} stopped`, failed > 0 && `${failed} failed`].filter((part) => part !== false);
  notify(`${what}${rest.length > 0 ? `; ${rest.join(", ")}` : ""}.`, failed > 0 ? "error" : "info");
}

function tellEnd(run: FitRun): void {
  const [first] = run.fits;
  if (!first) return;
  const state = first.state.peek();
  const alone = run.fits.length === 1;
  if (alone && state.kind === "done") {
    const { primitives, seconds, method } = state.result;
    notify(`${first.request.parameters["subsample"] ? method : methodsOf(run)} found ${plural(primitives, "primitive")} in ${first.model}, in ${seconds.toFixed(2)} s.`);
  } else if (alone && state.kind === "failed") {
    notify(`${first.model} could not be fitted: ${state.message}`, "error");
  } else {
    const tally = tallyOf(run);
    tellTally(`${methodsOf(run)} fitted ${tally.done} of ${run.fits.length}`, tally);
  }
}
