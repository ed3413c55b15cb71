// Has the models of a link again without their files, each kind of content as its own module says. One
// stop ends all of it.

import { computed, effect, signal } from "@preact/signals";
import { PUBLISHED_METHODS } from "../../shared/published/methods.mjs";
import { models, type ModelEntry } from "../state/models";
import { notify } from "../state/notices";
import type { JudgedClaim } from "./judge";
import * as fit from "./kinds/fit";
import * as publicModel from "./kinds/public-model";
import * as sample from "./kinds/sample";
import { judged, judging } from "./opened";
import { named } from "./names";
import { isRebuildable, UNASKED_LIMIT_SECONDS, type Wanted } from "./plan";
import type { Claim, SharedModel, SharedResults } from "./shared";
import { rebuilding, stopRebuilding, type Rebuilding } from "./state";
import { thisPage } from "./this-page";

/** The model on the page that a link speaks of. */
export function entryOf(shared: SharedModel): ModelEntry | undefined {
  return models.value.find(({ origin }) => isOf(origin, shared)) ?? models.value.find((entry) => isNamesake(entry, shared));
}

function isOf(here: ModelEntry["origin"], { origin }: SharedModel): boolean {
  if (origin.kind === "sample") return sample.isOf(here, origin);
  return origin.kind === "public" && publicModel.isOf(here, origin);
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

function isPublished({ method, fitted }: Claim): boolean {
  return fitted === undefined && (PUBLISHED_METHODS as readonly string[]).includes(method);
}

/** What of a link nobody has had again yet. */
export function restOf({ models: shared }: SharedResults): Wanted {
  const open = judged.value.filter(({ verdict }) => verdict.kind === "claimed" || verdict.kind === "other files");
  const fits = open.filter(({ claim, model }) => claim.fitted && isRecomputable(claim, model)).map(({ claim }) => claim);
  return { models: absentAmong(shared, [...shared.keys()]), fits };
}

function absentAmong(shared: readonly SharedModel[], places: readonly number[]): number[] {
  return places.filter((place) => {
    const model = shared[place];
    return model !== undefined && isRebuildable(model) && entryOf(model) === undefined;
  });
}

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

/** Which fits failed for a reason: `“PG” of “bracket” and 2 more`. */
export function fitsOf({ rows: [first, ...others] }: Failure): string {
  const more = others.length > 0 ? ` and ${others.length} more` : "";
  return first ? `${named(first.claim.method)} of ${named(first.model.name)}${more}` : "";
}

/**
 * Has again what is wanted and not here. What fails is told by its own part of the page, and of fits by
 * `failed`, too. What the reader did not ask for ends after `UNASKED_LIMIT_SECONDS` of computing.
 */
export async function rebuild(results: SharedResults, wanted: Wanted, { unasked = false } = {}): Promise<void> {
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
  const clock = new Clock(unasked ? UNASKED_LIMIT_SECONDS : Infinity, () => {
    controller.abort();
    notify(`What the link asks for took longer than ${UNASKED_LIMIT_SECONDS} s and was stopped. It goes on when you ask for it.`);
  });
  try {
    await clock.during(makeAgain(results, places, wanted.shown, stopped));
    if (!(await fetchAgain(results, places, stopped))) controller.abort();
    await clock.during(fitAgain(results, wanted.fits, stopped));
    if (!stopped.aborted) await judgedOf(own.awaited, stopped);
  } finally {
    if (rebuilding.value === own) rebuilding.value = undefined;
  }
}

/** Counts the time of some works, and acts once it is over. */
class Clock {
  #left: number;
  readonly #over: () => void;

  constructor(seconds: number, over: () => void) {
    this.#left = 1000 * seconds;
    this.#over = over;
  }

  async during(work: Promise<void>): Promise<void> {
    if (this.#left === Infinity) return work;
    const begun = performance.now();
    const timer = setTimeout(this.#over, this.#left);
    try {
      await work;
    } finally {
      clearTimeout(timer);
      this.#left = Math.max(0, this.#left - (performance.now() - begun));
    }
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
    if (origin?.kind === "sample") await sample.rebuild(origin, place === shown ? "shown" : "quiet", thisPage, stopped);
  }
}

/** Whoever stops the download does not want the rest either: then it is false. */
function fetchAgain({ models: shared, claims }: SharedResults, places: readonly number[], stopped: AbortSignal): Promise<boolean> {
  const asked = places.flatMap((place) => {
    const origin = shared[place]?.origin;
    if (origin?.kind !== "public" || !origin.model) return [];
    return [{ model: origin.model, withResults: claims.some((claim) => claim.model === place && isPublished(claim)) }];
  });
  return publicModel.rebuild(asked, thisPage, stopped);
}

async function fitAgain({ models: shared }: SharedResults, claims: readonly Claim[], stopped: AbortSignal): Promise<void> {
  const wanted = claims.flatMap((claim) => {
    const model = shared[claim.model];
    const entry = model && entryOf(model);
    return entry && claim.fitted ? [{ claim, job: { model: entry.id, request: claim.fitted } }] : [];
  });
  const reasons = await fit.rebuild(wanted.map(({ job }) => job), thisPage, stopped);
  const told = wanted.flatMap(({ claim }, at) => {
    const reason = reasons?.[at];
    return reason === undefined ? [] : [[claim, reason] as const];
  });
  failures.value = new Map([...failures.peek(), ...told]);
}
