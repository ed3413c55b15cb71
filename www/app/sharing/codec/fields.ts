// Parts of what a link holds that several versions have in common. Their layout is frozen: links are
// out in the world, and a change needs a function of another name for the versions to come.
//
// Lists of like things are written column by column, which deflate rewards.

import type { Measure, Protocol, SampleOptions } from "../../engine/contract";
import type { CameraState } from "../../view/types";
import { FINGERPRINT_BYTES, type Claim, type Fingerprint, type SharedOrigin } from "../shared";
import { Damaged, type ByteReader, type ByteWriter } from "./bytes";

/** More than the benchmark has, by far; a hostile link cannot make the page build more rows. */
export const MAX_MODELS = 500;
export const MAX_CLAIMS = 1000;
/** More points or primitives than any file may hold. */
export const MAX_NUMBER = 2 ** 32;

export const PROTOCOLS: readonly Protocol[] = ["definition", "published"];
export const ORIGINS = ["files", "sample", "public"] as const;
/** The measures of these versions, in the order of their bits. One declared since is in no link of theirs. */
const MEASURES = ["DSC", "PPV", "TPR", "TNR", "NPV", "ACC", "MFE", "dHaus", "d1"] as const satisfies readonly Measure[];
const OPTIONS = ["seed", "spacing", "noise", "outliers", "missing"] as const satisfies (keyof SampleOptions)[];
const PROJECTIONS = ["perspective", "orthographic"] as const;

export function writeSample(out: ByteWriter, { part, options }: Extract<SharedOrigin, { kind: "sample" }>): void {
  out.text(part);
  const given = OPTIONS.filter((option) => options[option] !== undefined);
  out.u8(given.reduce((mask, option) => mask | (1 << OPTIONS.indexOf(option)), 0));
  for (const option of given) out.f64(options[option] ?? 0);
}

export function readSample(from: ByteReader): SharedOrigin {
  const part = from.text();
  const mask = from.u8();
  const options: SampleOptions = {};
  OPTIONS.forEach((option, bit) => {
    if (mask & (1 << bit)) options[option] = from.f64();
  });
  return { kind: "sample", part, options };
}

/** Which measures a claim has, a bit for each. */
export function presence(mean: Claim["mean"]): number {
  return MEASURES.reduce((mask, measure, bit) => (hasValue(mean[measure]) ? mask | (1 << bit) : mask), 0);
}

function hasValue(value: number | null | undefined): value is number {
  return value !== null && value !== undefined;
}

/** What `presence` gives at most. */
export const ALL_PRESENT = 2 ** MEASURES.length - 1;

/** Of each measure the values, of the claims that have it. */
export function writeMeans(out: ByteWriter, claims: readonly Claim[]): void {
  for (const measure of MEASURES) {
    out.planes(claims.flatMap(({ mean }) => mean[measure] ?? []));
  }
}

export function readMeans(from: ByteReader, present: readonly number[]): Claim["mean"][] {
  const means = present.map((): Partial<Record<Measure, number | null>> => ({}));
  MEASURES.forEach((measure, bit) => {
    const holders = range(present.length).filter((i) => at(present, i) & (1 << bit));
    const values = from.planes(holders.length);
    for (const mean of means) mean[measure] = null;
    holders.forEach((i, rank) => (at(means, i)[measure] = values[rank] ?? null));
  });
  return means;
}

export function writeCamera(out: ByteWriter, camera: CameraState): void {
  for (const value of [...camera.target, ...camera.rotation, camera.height]) out.f32(value);
  out.u8(PROJECTIONS.indexOf(camera.projection));
}

export function readCamera(from: ByteReader): CameraState {
  const next = () => from.f32();
  return {
    target: [next(), next(), next()],
    rotation: [next(), next(), next(), next()],
    height: next(),
    projection: oneOf(PROJECTIONS, from.u8()),
  };
}

export function writeFingerprints(out: ByteWriter, fingerprints: readonly (Fingerprint | undefined)[]): void {
  for (const fingerprint of fingerprints) out.u8(fingerprint === undefined ? 0 : 1);
  for (const fingerprint of fingerprints) {
    if (fingerprint === undefined) continue;
    out.raw(range(FINGERPRINT_BYTES).map((i) => Number.parseInt(fingerprint.slice(2 * i, 2 * i + 2), 16)));
  }
}

export function readFingerprints(from: ByteReader, length: number): (Fingerprint | undefined)[] {
  const given = range(length).map(() => from.u8() === 1);
  return given.map((is) => {
    if (!is) return undefined;
    return Array.from(from.raw(FINGERPRINT_BYTES), (byte) => byte.toString(16).padStart(2, "0")).join("");
  });
}

export function range(length: number): number[] {
  return Array.from({ length }, (_, i) => i);
}

export function at<T>(list: readonly T[], index: number): T {
  const value = list[index];
  if (value === undefined) throw new Damaged("it refers to something that is not there");
  return value;
}

export function oneOf<T>(list: readonly T[], index: number): T {
  return at(list, index);
}

export function below(index: number, length: number): number {
  if (index >= length) throw new Damaged("it refers to a model that is not there");
  return index;
}
