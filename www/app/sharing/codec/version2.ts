// Version 2 of what a link holds: version 1, and which public model it is, how the page fitted a
// submission, and what the two views show. It is frozen: links of this version are out in the world,
// and a change of layout needs a new version beside it.

import type { FitRequest } from "../../../worker/protocol";
import { SETS } from "../../public/catalogue";
import type { Claim, SharedModel, SharedOrigin, SharedResults, SharedView } from "../shared";
import { ByteReader, ByteWriter } from "./bytes";
import {
  at,
  MAX_CLAIMS,
  MAX_MODELS,
  MAX_NUMBER,
  oneOf,
  ORIGINS,
  presence,
  PROTOCOLS,
  range,
  writeCamera,
  writeFingerprints,
  writeMeans,
  writeSample,
} from "./fields";
import { readLayout, type Layout } from "./layout";

const SET_NAMES = SETS.map(({ name }) => name);
const FITTERS = ["ht", "pg"] as const;
/** More ways of fitting than anybody compares, and more parameters than a fitter has. */
const MAX_REQUESTS = 200;
const MAX_PARAMETERS = 64;

const LAYOUT: Layout = {
  sides: ["truth", "prediction", "rival"],
  viewFields: 0b111_1111,
  readPublic,
  readFitted,
};

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
  return readLayout(LAYOUT, bytes);
}

function writeModels(out: ByteWriter, models: readonly SharedModel[]): void {
  if (models.length > MAX_MODELS) throw new RangeError(`more than ${MAX_MODELS} models`);
  out.whole(models.length);
  for (const { name } of models) out.text(name);
  for (const { points } of models) out.whole(points);
  for (const { truth } of models) out.whole(truth);
  for (const { origin } of models) out.u8(ORIGINS.indexOf(origin.kind));
  for (const { origin } of models) if (origin.kind === "sample") writeSample(out, origin);
  for (const { origin } of models) if (origin.kind === "public") writePublic(out, origin);
  writeFingerprints(out, models.map(({ inputs }) => inputs));
}

function writePublic(out: ByteWriter, { model }: Extract<SharedOrigin, { kind: "public" }>): void {
  // One that a link of version 1 did not name has number 0.
  out.u8(Math.max(0, SET_NAMES.findIndex((name) => name === model?.set)));
  out.whole(model?.number ?? 0);
}

function readPublic(from: ByteReader): SharedOrigin {
  const set = oneOf(SETS, from.u8());
  const number = from.whole(set.count);
  return number === 0 ? { kind: "public" } : { kind: "public", model: { set: set.name, number } };
}

/** A list of the ways to fit, each of which many claims may share. */
function writeRequests(out: ByteWriter, requests: readonly string[]): void {
  if (requests.length > MAX_REQUESTS) throw new RangeError(`more than ${MAX_REQUESTS} ways to fit`);
  out.whole(requests.length);
  for (const request of requests) {
    const { method, seed, parameters } = JSON.parse(request) as FitRequest;
    const given = Object.entries(parameters);
    out.u8(FITTERS.indexOf(method));
    out.whole(seed);
    out.whole(given.length);
    for (const [name, value] of given) {
      out.text(name);
      out.f64(value);
    }
  }
}

function readRequests(from: ByteReader): FitRequest[] {
  return range(from.count(MAX_REQUESTS)).map(() => {
    const method = oneOf(FITTERS, from.u8());
    const seed = from.whole(MAX_NUMBER - 1);
    const given = range(from.count(MAX_PARAMETERS)).map(() => [from.text(), from.f64()] as const);
    return { method, seed, parameters: Object.fromEntries(given) };
  });
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
  const requests = claims.map(({ fitted }) => (fitted ? requestText(fitted) : undefined));
  const ways = [...new Set(requests)].filter((request) => request !== undefined);
  writeRequests(out, ways);
  for (const request of requests) out.whole(request === undefined ? 0 : ways.indexOf(request) + 1);
  writeFingerprints(out, claims.map(({ submission }) => submission));
  writeMeans(out, claims);
}

/** Equal for equal requests, in whatever order their parameters were set. */
function requestText({ method, seed, parameters }: FitRequest): string {
  const sorted = Object.entries(parameters).sort(([a], [b]) => (a < b ? -1 : 1));
  return JSON.stringify({ method, seed, parameters: Object.fromEntries(sorted) });
}

/** The way of each claim, by its place in the list of ways, from 1; 0 is none. */
function readFitted(from: ByteReader, claims: number): (FitRequest | undefined)[] {
  const ways = readRequests(from);
  const places = range(claims).map(() => from.whole(ways.length));
  return places.map((place) => (place > 0 ? at(ways, place - 1) : undefined));
}

function writeView(out: ByteWriter, view: SharedView | undefined): void {
  out.u8(view ? 1 : 0);
  if (!view) return;
  const { model, method, primitive, camera, colour, arrangement, left, rightIsTruth } = view;
  out.whole(model);
  const given = [method, primitive, camera, colour, arrangement, left, rightIsTruth];
  out.u8(given.reduce<number>((mask, value, bit) => (value === undefined ? mask : mask | (1 << bit)), 0));
  if (method !== undefined) out.text(method);
  if (primitive) {
    out.u8(LAYOUT.sides.indexOf(primitive.side));
    out.whole(primitive.index);
  }
  if (camera) writeCamera(out, camera);
  if (colour !== undefined) out.text(colour);
  if (arrangement !== undefined) out.text(arrangement);
  if (left !== undefined) out.text(left);
}
