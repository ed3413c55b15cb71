// Version 1 of what a link holds. It is frozen: links of this version are out in the world, and a
// change of layout needs a new version beside it.
//
// Lists of like things are written column by column, which deflate rewards.

import { MEASURES } from "../../../../bin/formats/measures.mjs";
import type { Measure, Protocol, SampleOptions } from "../../engine/contract";
import type { CameraState } from "../../view/types";
import { FINGERPRINT_BYTES, type Claim, type Fingerprint, type SharedModel, type SharedOrigin, type SharedResults, type SharedView } from "../shared";
import { ByteReader, ByteWriter, Damaged } from "./bytes";

/** More than the benchmark has, by far; a hostile link cannot make the page build more rows. */
export const MAX_MODELS = 500;
export const MAX_CLAIMS = 1000;
/** More points or primitives than any file may hold. */
const MAX_NUMBER = 2 ** 32;

const PROTOCOLS: readonly Protocol[] = ["definition", "published"];
const ORIGINS = ["files", "sample", "public"] as const;
const OPTIONS = ["seed", "spacing", "noise", "outliers", "missing"] as const satisfies (keyof SampleOptions)[];
const SIDES = ["truth", "prediction"] as const;
const PROJECTIONS = ["perspective", "orthographic"] as const;

export function write(results: SharedResults): Uint8Array<ArrayBuffer> {
  const out = new ByteWriter();
  out.text(results.engine);
  out.u8(PROTOCOLS.indexOf(results.protocol));
  writeModels(out, results.models);
  writeClaims(out, results.claims);
  writeView(out, results.view);
  return out.finish();
}

export function read(bytes: Uint8Array<ArrayBuffer>): SharedResults {
  const from = new ByteReader(bytes);
  const engine = from.text();
  const protocol = oneOf(PROTOCOLS, from.u8());
  const models = readModels(from);
  const claims = readClaims(from, models.length);
  const view = readView(from, models.length);
  from.end();
  return { engine, protocol, models, claims, ...(view && { view }) };
}

function writeModels(out: ByteWriter, models: readonly SharedModel[]): void {
  if (models.length > MAX_MODELS) throw new RangeError(`more than ${MAX_MODELS} models`);
  out.whole(models.length);
  for (const { name } of models) out.text(name);
  for (const { points } of models) out.whole(points);
  for (const { truth } of models) out.whole(truth);
  for (const { origin } of models) out.u8(ORIGINS.indexOf(origin.kind));
  for (const { origin } of models) if (origin.kind === "sample") writeSample(out, origin);
  writeFingerprints(out, models.map(({ inputs }) => inputs));
}

function readModels(from: ByteReader): SharedModel[] {
  const places = range(from.count(MAX_MODELS));
  const names = places.map(() => from.text());
  const points = places.map(() => from.whole(MAX_NUMBER));
  const truths = places.map(() => from.whole(MAX_NUMBER));
  const kinds = places.map(() => oneOf(ORIGINS, from.u8()));
  const origins = kinds.map((kind): SharedOrigin => (kind === "sample" ? readSample(from) : { kind }));
  const inputs = readFingerprints(from, places.length);
  return places.map((i) => ({
    name: at(names, i),
    points: at(points, i),
    truth: at(truths, i),
    origin: at(origins, i),
    ...(inputs[i] && { inputs: inputs[i] }),
  }));
}

function writeSample(out: ByteWriter, { part, options }: Extract<SharedOrigin, { kind: "sample" }>): void {
  out.text(part);
  const given = OPTIONS.filter((option) => options[option] !== undefined);
  out.u8(given.reduce((mask, option) => mask | (1 << OPTIONS.indexOf(option)), 0));
  for (const option of given) out.f64(options[option] ?? 0);
}

function readSample(from: ByteReader): SharedOrigin {
  const part = from.text();
  const mask = from.u8();
  const options: SampleOptions = {};
  OPTIONS.forEach((option, bit) => {
    if (mask & (1 << bit)) options[option] = from.f64();
  });
  return { kind: "sample", part, options };
}

function writeClaims(out: ByteWriter, claims: readonly Claim[]): void {
  if (claims.length > MAX_CLAIMS) throw new RangeError(`more than ${MAX_CLAIMS} results`);
  const methods = [...new Set(claims.map(({ method }) => method))];
  out.whole(methods.length);
  for (const method of methods) out.text(method);
  out.whole(claims.length);
  for (const { model } of claims) out.whole(model);
  for (const { method } of claims) out.whole(methods.indexOf(method));
  for (const { predicted } of claims) out.whole(predicted);
  for (const { typeErrors } of claims) out.whole(typeErrors);
  for (const { mean } of claims) out.whole(presence(mean));
  writeFingerprints(out, claims.map(({ submission }) => submission));
  for (const measure of MEASURES) {
    out.planes(claims.flatMap(({ mean }) => mean[measure] ?? []));
  }
}

function readClaims(from: ByteReader, models: number): Claim[] {
  const methods = range(from.count(MAX_CLAIMS)).map(() => from.text());
  const places = range(from.count(MAX_CLAIMS));
  const claimed = places.map(() => from.whole());
  const named = places.map(() => from.whole());
  const predicted = places.map(() => from.whole(MAX_NUMBER));
  const typeErrors = places.map(() => from.whole(MAX_NUMBER));
  const present = places.map(() => from.whole(2 ** MEASURES.length - 1));
  const submissions = readFingerprints(from, places.length);
  const means = places.map(() => ({}) as Record<Measure, number | null>);
  MEASURES.forEach((measure, bit) => {
    const holders = places.filter((i) => at(present, i) & (1 << bit));
    const values = from.planes(holders.length);
    for (const mean of means) mean[measure] = null;
    holders.forEach((i, rank) => (at(means, i)[measure] = values[rank] ?? null));
  });
  return places.map((i) => ({
    model: below(at(claimed, i), models),
    method: at(methods, at(named, i)),
    predicted: at(predicted, i),
    typeErrors: at(typeErrors, i),
    mean: at(means, i),
    ...(submissions[i] && { submission: submissions[i] }),
  }));
}

function presence(mean: Claim["mean"]): number {
  return MEASURES.reduce((mask, measure, bit) => (mean[measure] === null ? mask : mask | (1 << bit)), 0);
}

function writeView(out: ByteWriter, view: SharedView | undefined): void {
  out.u8(view ? 1 : 0);
  if (!view) return;
  const { model, method, primitive, camera, colour, arrangement } = view;
  out.whole(model);
  const given = [method, primitive, camera, colour, arrangement];
  out.u8(given.reduce<number>((mask, value, bit) => (value === undefined ? mask : mask | (1 << bit)), 0));
  if (method !== undefined) out.text(method);
  if (primitive) {
    out.u8(SIDES.indexOf(primitive.side));
    out.whole(primitive.index);
  }
  if (camera) {
    for (const value of [...camera.target, ...camera.rotation, camera.height]) out.f32(value);
    out.u8(PROJECTIONS.indexOf(camera.projection));
  }
  if (colour !== undefined) out.text(colour);
  if (arrangement !== undefined) out.text(arrangement);
}

function readView(from: ByteReader, models: number): SharedView | undefined {
  if (from.u8() === 0) return undefined;
  const model = below(from.whole(), models);
  const mask = from.u8();
  return {
    model,
    ...(mask & 1 && { method: from.text() }),
    ...(mask & 2 && { primitive: { side: oneOf(SIDES, from.u8()), index: from.whole(MAX_NUMBER) } }),
    ...(mask & 4 && { camera: readCamera(from) }),
    ...(mask & 8 && { colour: from.text() }),
    ...(mask & 16 && { arrangement: from.text() }),
  };
}

function readCamera(from: ByteReader): CameraState {
  const next = () => from.f32();
  return {
    target: [next(), next(), next()],
    rotation: [next(), next(), next(), next()],
    height: next(),
    projection: oneOf(PROJECTIONS, from.u8()),
  };
}

function writeFingerprints(out: ByteWriter, fingerprints: readonly (Fingerprint | undefined)[]): void {
  for (const fingerprint of fingerprints) out.u8(fingerprint === undefined ? 0 : 1);
  for (const fingerprint of fingerprints) {
    if (fingerprint === undefined) continue;
    out.raw(range(FINGERPRINT_BYTES).map((i) => Number.parseInt(fingerprint.slice(2 * i, 2 * i + 2), 16)));
  }
}

function readFingerprints(from: ByteReader, length: number): (Fingerprint | undefined)[] {
  const given = range(length).map(() => from.u8() === 1);
  return given.map((is) => {
    if (!is) return undefined;
    return Array.from(from.raw(FINGERPRINT_BYTES), (byte) => byte.toString(16).padStart(2, "0")).join("");
  });
}

function range(length: number): number[] {
  return Array.from({ length }, (_, i) => i);
}

function at<T>(list: readonly T[], index: number): T {
  const value = list[index];
  if (value === undefined) throw new Damaged("it refers to something that is not there");
  return value;
}

function oneOf<T>(list: readonly T[], index: number): T {
  return at(list, index);
}

function below(index: number, length: number): number {
  if (index >= length) throw new Damaged("it refers to a model that is not there");
  return index;
}
