// How long a fit will take: told before it begins, by the points of the cloud and what fits took so far.

import type { FitRequest } from "../../worker/protocol";
import type { FitDone } from "../state/fitting";

/** Seconds, and between what they may well lie. */
export interface Estimate {
  readonly seconds: number;
  readonly from: number;
  readonly to: number;
  /** The fits it goes by: none where it is what clouds took elsewhere. */
  readonly fits: number;
}

/** Seconds of the smallest fit, and for each point of a cloud: between a clean one (6 µs) and one with noise (60 µs), as the generated parts take on one thread of this engine. */
const LEAST = 0.1;
const EACH = 20e-6;
/** How many times less or more it may be: of any cloud on any machine, after one fit here, at best. */
const UNKNOWN = 4;
const ONE = 3;
const KNOWN = 1.6;
/** Of these the last ones count: settings and clouds change. */
const HEARD = 8;

/**
 * What a fit of a cloud of so many points will take, by the fits of that method done here: they tell how fast this machine is,
 * and what clouds are like. One of the very same model tells most.
 */
export function estimate({ method, model, points }: Omit<FitDone, "seconds">, done: readonly FitDone[]): Estimate {
  const own = done.filter((each) => each.method === method);
  const same = own.filter((each) => each.model === model && each.points === points);
  const heard = (same.length > 0 ? same : own).slice(-HEARD);
  const logs = heard.map((each) => Math.log(each.seconds / usual(each.points)));
  const mean = logs.reduce((sum, log) => sum + log, 0) / (logs.length || 1);
  const seconds = usual(points) * Math.exp(mean);
  const factor = same.length > 0 ? KNOWN : spread(logs, mean);
  return { seconds, from: seconds / factor, to: seconds * factor, fits: heard.length };
}

/** Points of a cloud that a fit is made of: those of a subsample where one is asked for. */
export function pointsFitted(points: number, { parameters }: Pick<FitRequest, "parameters">): number {
  const { subsample = 0 } = parameters;
  return subsample > 0 ? Math.min(points, subsample) : points;
}

/** Who waits as long as this may do with less. */
export const LONG_SECONDS = 60;
/** And not with an answer that takes longer than this. */
const SHORT_SECONDS = 20;
/** Round numbers of points, of which the largest is proposed that takes no longer: fewer show no small face. */
const SUBSAMPLES = [1_000_000, 500_000, 200_000, 100_000, 50_000];
/** Seconds that each point takes which is only labelled: it is put in order, and the nearest of those fitted looked up. */
const EACH_LABELLED = 3e-6;

/** A fit of some of the points where that of all may take minutes: how many, and how long. */
export function proposal(asked: Omit<FitDone, "seconds">, done: readonly FitDone[]): { points: number; estimate: Estimate } | undefined {
  if (estimate(asked, done).to < LONG_SECONDS) return undefined;
  const all = SUBSAMPLES.filter((points) => points < asked.points / 2).map((points) => {
    const { seconds, from, to, fits } = estimate({ ...asked, points }, done);
    // As much faster or slower as fits are here.
    const labelled = EACH_LABELLED * asked.points * (seconds / usual(points));
    return { points, estimate: { seconds: seconds + labelled, from: from + labelled, to: to + labelled, fits } };
  });
  return all.find(({ estimate: { to } }) => to <= SHORT_SECONDS) ?? all.at(-1);
}

/** Fits side by side, `workers` at once. */
export function together(all: readonly Estimate[], workers: number): Estimate {
  const sum = (of: (each: Estimate) => number) => all.reduce((total, each) => total + of(each), 0) / Math.min(workers, all.length || 1);
  return { seconds: sum(({ seconds }) => seconds), from: sum(({ from }) => from), to: sum(({ to }) => to), fits: Math.max(0, ...all.map(({ fits }) => fits)) };
}

function usual(points: number): number {
  return LEAST + EACH * points;
}

/** The factor within which about nineteen of twenty lie, as far as so few tell. */
function spread(logs: readonly number[], mean: number): number {
  if (logs.length === 0) return UNKNOWN;
  if (logs.length === 1) return ONE;
  const deviation = Math.sqrt(logs.reduce((sum, log) => sum + (log - mean) ** 2, 0) / (logs.length - 1));
  return Math.min(UNKNOWN, Math.max(KNOWN, Math.exp(2 * deviation)));
}

/** Roughly: `under 1 s`, `7 s`, `40 s`, `3 min`, `2 h`. */
export function roughly(seconds: number): string {
  if (seconds < 1) return "under 1 s";
  if (seconds < 10) return `${Math.round(seconds)} s`;
  if (seconds < 90) return `${5 * Math.round(seconds / 5)} s`;
  return seconds < 5400 ? `${Math.round(seconds / 60)} min` : `${Math.round(seconds / 3600)} h`;
}

/** From the least to the most, once where both read alike: `2 to 9 s`, `40 s to 3 min`, `under 1 s`. */
export function range({ from, to }: Estimate): string {
  const [least, most] = [roughly(from), roughly(to)];
  if (least === most) return least;
  // It may take next to nothing: how much less than a second, nobody needs to know.
  if (from < 1) return `up to ${most}`;
  const unit = / \w+$/.exec(most)?.[0] ?? "";
  return `${least.endsWith(unit) ? least.slice(0, -unit.length) : least} to ${most}`;
}
