// What of a link is had again, what that costs, roughly, and how much of it a link may have unasked.

import { initialOf, nameOfSample } from "../samples/identity";
import { capitalised, duration, plural } from "../ui/format";
import type { Claim, SharedModel, SharedOrigin, SharedResults } from "./shared";

/** What is to be had again of a link. */
export interface Wanted {
  /** Places of models among those of the link. */
  readonly models: readonly number[];
  /** The one of them that comes into view. */
  readonly shown?: number | undefined;
  /** Claims to be fitted for. */
  readonly fits: readonly Claim[];
}

/**
 * Points of a sample, times the square of its spacing: from 0.6 (shaft) to 3.0 (heat sink), 0.95 in the
 * median over the catalogue. How many points a link claims is no measure of what it asks for.
 */
const SAMPLE_POINTS = 1;
/** The engine makes no more. */
const MAX_SAMPLE_POINTS = 2_000_000;
/** The largest cloud of the training set has 48,929 points: no public model is taken for larger, whatever is claimed. */
const MAX_PUBLIC_POINTS = 50_000;
/** Making a sample and scoring its submission, per point: 2 to 11 µs over the catalogue to make, and as much again. */
const SAMPLE_SECONDS = 1e-5;
/** Fitting a cloud: 0.1 s in the median over the training set, 4.7 s at a million points of one part. */
const FIT_SECONDS = { each: 0.1, perPoint: 5e-6 };

/** A link that takes no longer is opened whole; of one that does, what is looked at. */
export const UNASKED_SECONDS = 5;
/** What a link has done unasked ends after this, however it came to take longer than it should. */
export const UNASKED_LIMIT_SECONDS = 20;
/** Fits done unasked: those of the two submissions in view. */
const UNASKED_FITS = 2;
/** Samples made unasked: each adds a row to the page. */
const UNASKED_SAMPLES = 12;

/** Whether a model can be had again from what the link says of it. */
export function isRebuildable({ origin }: SharedModel): boolean {
  return origin.kind === "sample" || (origin.kind === "public" && origin.model !== undefined);
}

function pointsOf({ origin, points }: SharedModel): number {
  if (origin.kind === "public") return Math.min(points, MAX_PUBLIC_POINTS);
  if (origin.kind === "files") return points;
  const spacing = origin.options.spacing ?? initialOf("spacing");
  return Math.min(MAX_SAMPLE_POINTS, SAMPLE_POINTS / spacing ** 2);
}

/** Seconds of computing, roughly; downloads are not counted. */
export function secondsOf({ models: shared }: SharedResults, { models: places, fits }: Wanted): number {
  const of = (place: number) => shared[place];
  const samples = places.flatMap((place) => of(place) ?? []).filter(({ origin }) => origin.kind === "sample");
  const fitted = fits.flatMap(({ model }) => of(model) ?? []);
  const sum = (all: readonly SharedModel[], each: (points: number) => number) => all.reduce((total, model) => total + each(pointsOf(model)), 0);
  return sum(samples, (points) => SAMPLE_SECONDS * points) + sum(fitted, (points) => FIT_SECONDS.each + FIT_SECONDS.perPoint * points);
}

/** Having it again, in words; nothing where there is nothing to be had. */
export function workOf(results: SharedResults, wanted: Wanted): string | undefined {
  const of = (kind: SharedOrigin["kind"]) => wanted.models.filter((place) => results.models[place]?.origin.kind === kind).length;
  const [samples, downloads, fits] = [of("sample"), of("public"), wanted.fits.length];
  const parts = [
    samples > 0 && `make ${plural(samples, "sample")}`,
    downloads > 0 && `download ${plural(downloads, "public model")}`,
    fits > 0 && `repeat ${plural(fits, "fit")}`,
  ].filter((part) => part !== false);
  if (parts.length === 0) return undefined;
  const seconds = secondsOf(results, wanted);
  return `${capitalised(parts.join(", "))}${seconds > 0 ? ` (about ${duration(1000 * seconds)})` : ""}`;
}

/**
 * What opening a link does unasked: the model looked at, where it is quickly had, with the fits in view,
 * and other samples as long as all of it stays below `UNASKED_SECONDS`. A link must not keep the machine busy.
 */
export function unaskedOf(results: SharedResults): Wanted {
  const { models: shared, claims, view } = results;
  const shown = view?.model;
  let wanted: Wanted = { models: [], fits: [] };
  const take = (more: Partial<Wanted>): void => {
    const next = { ...wanted, ...more };
    if (secondsOf(results, next) <= UNASKED_SECONDS) wanted = next;
  };
  const looked = shown === undefined ? undefined : shared[shown];
  if (looked && shown !== undefined && isRebuildable(looked)) {
    take({ models: [shown], shown });
    const inView = claims.filter(({ model, method, fitted }) => fitted && model === shown && (method === view?.method || method === view?.left));
    // A fit is of no use without its model.
    if (wanted.models.length > 0) for (const claim of inView.slice(0, UNASKED_FITS)) take({ fits: [...wanted.fits, claim] });
  }
  const made = new Set(looked?.origin.kind === "sample" ? [nameOfSample(looked.origin)] : []);
  for (const [place, { origin }] of shared.entries()) {
    if (origin.kind !== "sample" || made.size > UNASKED_SAMPLES || made.has(nameOfSample(origin))) continue;
    made.add(nameOfSample(origin));
    take({ models: [...wanted.models, place] });
  }
  return wanted;
}
