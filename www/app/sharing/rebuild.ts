// Has the models of a link again without their files: samples are made, public models downloaded,
// fits repeated. One stop ends all of it.

import { computed, effect, signal } from "@preact/signals";
import { downloadModels } from "../public/download";
import { publicBase } from "../public/source";
import { SETS, type PublicModel } from "../public/catalogue";
import { isSameSample } from "../samples/identity";
import { makeSample } from "../samples/samples";
import { fitModels, tallyOf, tellTally } from "../state/fitting";
import { models, type ModelEntry, type Origin } from "../state/models";
import { notify } from "../state/notices";
import { capitalised, plural } from "../ui/format";
import { judged, judging, type JudgedClaim } from "./opened";
import type { Claim, SharedModel, SharedOrigin, SharedResults } from "./shared";

/** The public repository has results of these for the test set. */
const PUBLISHED: readonly string[] = ["HT", "PG"];

/** Whether a model can be had again from what the link says of it. */
export function isRebuildable({ origin }: SharedModel): boolean {
  return origin.kind === "sample" || (origin.kind === "public" && origin.model !== undefined);
}

/** The model on the page that a link speaks of. */
export function entryOf(shared: SharedModel): ModelEntry | undefined {
  return models.value.find(({ origin }) => isSame(origin, shared.origin)) ?? models.value.find((entry) => isNamesake(entry, shared));
}

function isSame(here: Origin, shared: SharedOrigin): boolean {
  if (shared.kind === "sample") return isSameSample(here, shared);
  if (shared.kind !== "public" || here.kind !== "public") return false;
  return shared.model?.set === here.model.set && shared.model.number === here.model.number;
}

/** By name alone: files that the reader brought. A sample of that name may be another sample of the part. */
function isNamesake({ id, origin }: ModelEntry, { name, origin: shared }: SharedModel): boolean {
  if (id !== name || shared.kind === "sample") return false;
  // Links of version 1 do not say which public model it was.
  return origin.kind === "files" || (origin.kind === "public" && shared.kind === "public" && shared.model === undefined);
}

/** Whether a claim's submission can be had without the reader's doing: fitted again, or with the model. */
function isRecomputable(claim: Claim, model: SharedModel): boolean {
  const isHere = entryOf(model) !== undefined;
  return claim.fitted ? isHere || isRebuildable(model) : !isHere && comesAlong(claim, model);
}

/** A sample comes with its imperfect submission, a public model with the published results. */
function comesAlong(claim: Claim, model: SharedModel): boolean {
  return !claim.fitted && isRebuildable(model) && (model.origin.kind === "sample" || isPublished(claim));
}

/** What is to be had again of a link. */
export interface Wanted {
  /** Places of models among those of the link. */
  readonly models: readonly number[];
  /** The one of them that comes into view. */
  readonly shown?: number | undefined;
  /** Claims to be fitted for. */
  readonly fits: readonly Claim[];
}

/** What of a link nobody has had again yet. */
export function restOf({ models: shared }: SharedResults): Wanted {
  const open = judged.value.filter(({ verdict }) => verdict.kind === "claimed" || verdict.kind === "other files");
  const fits = open.filter(({ claim, model }) => claim.fitted && isRecomputable(claim, model)).map(({ claim }) => claim);
  return { models: absentAmong(shared, [...shared.keys()]), fits };
}

/** What having it again takes, in words; nothing where there is nothing to be had. */
export function workOf({ models: shared }: SharedResults, { models: places, fits }: Wanted): string | undefined {
  const of = (kind: SharedOrigin["kind"]) => places.filter((place) => shared[place]?.origin.kind === kind).length;
  const [samples, downloads] = [of("sample"), of("public")];
  const parts = [
    samples > 0 && `make ${plural(samples, "sample")}`,
    downloads > 0 && `download ${plural(downloads, "public model")}`,
    fits.length > 0 && `repeat ${plural(fits.length, "fit")}`,
  ].filter((part) => part !== false);
  const text = parts.join(", ");
  return text === "" ? undefined : capitalised(text);
}

function absentAmong(shared: readonly SharedModel[], places: readonly number[]): number[] {
  return places.filter((place) => {
    const model = shared[place];
    return model !== undefined && isRebuildable(model) && entryOf(model) === undefined;
  });
}

/** What is being had again just now. */
export interface Rebuilding {
  /** Claims whose figures are awaited. */
  readonly awaited: ReadonlySet<Claim>;
  readonly stop: () => void;
}

export const rebuilding = signal<Rebuilding | undefined>(undefined);

/** Why the fits of claims failed here. */
const failures = signal<ReadonlyMap<Claim, string>>(new Map());

/** How a claim that nothing here bears out yet stands. */
export type Recomputing = "under way" | "failed" | "not done" | "not possible";

export function recomputingOf({ claim, model }: JudgedClaim): Recomputing {
  if (rebuilding.value?.awaited.has(claim)) return "under way";
  if (failures.value.has(claim)) return "failed";
  return isRecomputable(claim, model) ? "not done" : "not possible";
}

export interface Failure {
  readonly reason: string;
  /** The claims whose fits failed for it. */
  readonly rows: readonly JudgedClaim[];
}

/** Why what is claimed could not be fitted again, each reason once. */
export const failed = computed<readonly Failure[]>(() => {
  const byReason = new Map<string, JudgedClaim[]>();
  for (const row of judged.value) {
    const reason = row.verdict.kind === "claimed" && recomputingOf(row) === "failed" ? failures.value.get(row.claim) : undefined;
    if (reason !== undefined) byReason.set(reason, [...(byReason.get(reason) ?? []), row]);
  }
  return Array.from(byReason, ([reason, rows]) => ({ reason, rows }));
});

/** Which fits failed for a reason: `PG of bracket and 2 more`. */
export function fitsOf({ rows: [first, ...others] }: Failure): string {
  const more = others.length > 0 ? ` and ${others.length} more` : "";
  return `${first?.claim.method} of ${first?.model.name}${more}`;
}

/** Ends the making of samples, the download and the fits that a link asked for. What is here stays. */
export function stopRebuilding(): void {
  rebuilding.peek()?.stop();
}

/** Has again what is wanted and not here. What fails is told by its own part of the page, and of fits by `failed`, too. */
export async function rebuild(results: SharedResults, wanted: Wanted): Promise<void> {
  stopRebuilding();
  const places = absentAmong(results.models, wanted.models);
  if (places.length + wanted.fits.length === 0) return;
  const controller = new AbortController();
  const { signal: stopped } = controller;
  const along = judged.peek().filter(({ claim, model }) => places.includes(claim.model) && comesAlong(claim, model));
  const own: Rebuilding = {
    awaited: new Set([...wanted.fits, ...along.map(({ claim }) => claim)]),
    stop: () => controller.abort(),
  };
  rebuilding.value = own;
  // Of another link, or about to be tried again.
  failures.value = new Map([...failures.peek()].filter(([claim]) => results.claims.includes(claim) && !wanted.fits.includes(claim)));
  try {
    await makeAgain(results, places, wanted.shown, stopped);
    await fetchAgain(results, places, controller);
    await fitAgain(results, wanted.fits, stopped);
    if (!stopped.aborted) await judgedOf(own.awaited, stopped);
  } finally {
    if (rebuilding.value === own) rebuilding.value = undefined;
  }
}

/** Resolves once there is a verdict on each claim, or none to come: what could not be had never gets one. */
function judgedOf(claims: ReadonlySet<Claim>, stopped: AbortSignal): Promise<void> {
  return new Promise((resolve) => {
    const end = effect(() => {
      const open = judged.value.some(({ claim, verdict }) => claims.has(claim) && verdict.kind === "claimed");
      if (!open || !judging.value) queueMicrotask(settle);
    });
    stopped.addEventListener("abort", settle, { once: true });
    function settle(): void {
      end();
      resolve();
    }
  });
}

/** What comes into view comes first. */
async function makeAgain({ models: shared }: SharedResults, places: readonly number[], shown: number | undefined, stopped: AbortSignal): Promise<void> {
  const inOrder = [...places.filter((place) => place === shown), ...places.filter((place) => place !== shown)];
  for (const place of inOrder) {
    if (stopped.aborted) return;
    const origin = shared[place]?.origin;
    if (origin?.kind === "sample") await makeSample(origin.part, origin.options, place === shown ? "shown" : "quiet", stopped);
  }
}

async function fetchAgain({ models: shared, claims }: SharedResults, places: readonly number[], controller: AbortController): Promise<void> {
  const base = publicBase();
  if (base.kind === "refused") return;
  for (const { name: set } of SETS) {
    for (const withResults of [false, true]) {
      const numbers = places.flatMap((place) => {
        const model = publicModelOf(shared[place]);
        const published = claims.some((claim) => claim.model === place && isPublished(claim));
        return model?.set === set && published === withResults ? [model.number] : [];
      });
      if (numbers.length === 0 || controller.signal.aborted) continue;
      const ending = await downloadModels(base.address, { set, numbers, withResults }, controller.signal);
      // Whoever stops the download does not want the rest either.
      if (ending === "stopped") controller.abort();
    }
  }
}

function publicModelOf(model: SharedModel | undefined): PublicModel | undefined {
  return model?.origin.kind === "public" ? model.origin.model : undefined;
}

function isPublished({ method, fitted }: Claim): boolean {
  return fitted === undefined && PUBLISHED.includes(method);
}

/** Fits of one model are in the order of the claims, in which they got their names. */
async function fitAgain({ models: shared }: SharedResults, claims: readonly Claim[], stopped: AbortSignal): Promise<void> {
  const wanted = claims.flatMap((claim) => {
    const model = shared[claim.model];
    const entry = model && entryOf(model);
    return entry && claim.fitted ? [{ claim, job: { model: entry.id, request: claim.fitted } }] : [];
  });
  if (wanted.length === 0 || stopped.aborted) return;
  const run = await fitModels(wanted.map(({ job }) => job), { signal: stopped, quiet: true });
  if (!run) return notify("The fits of the link were not repeated: another fit is under way.");
  const reasons = wanted.flatMap(({ claim }, at) => {
    const state = run.fits[at]?.state.peek();
    return state?.kind === "failed" ? [[claim, state.message] as const] : [];
  });
  failures.value = new Map([...failures.peek(), ...reasons]);
  const tally = tallyOf(run);
  const count = plural(wanted.length, "fit");
  tellTally(`${tally.done === wanted.length ? count : `${tally.done} of ${count}`} of the link repeated here`, tally);
}
