// Version 1 of what a link holds: read for ever, written no more.

import type { Claim, SharedModel, SharedOrigin, SharedResults, SharedView } from "../shared";
import { ByteReader } from "./bytes";
import {
  ALL_PRESENT,
  at,
  below,
  MAX_CLAIMS,
  MAX_MODELS,
  MAX_NUMBER,
  oneOf,
  ORIGINS,
  PROTOCOLS,
  range,
  readCamera,
  readFingerprints,
  readMeans,
  readSample,
} from "./fields";

const SIDES = ["truth", "prediction"] as const;

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

function readClaims(from: ByteReader, models: number): Claim[] {
  const methods = range(from.count(MAX_CLAIMS)).map(() => from.text());
  const places = range(from.count(MAX_CLAIMS));
  const claimed = places.map(() => from.whole());
  const named = places.map(() => from.whole());
  const predicted = places.map(() => from.whole(MAX_NUMBER));
  const typeErrors = places.map(() => from.whole(MAX_NUMBER));
  const present = places.map(() => from.whole(ALL_PRESENT));
  const submissions = readFingerprints(from, places.length);
  const means = readMeans(from, present);
  return places.map((i) => ({
    model: below(at(claimed, i), models),
    method: at(methods, at(named, i)),
    predicted: at(predicted, i),
    typeErrors: at(typeErrors, i),
    mean: at(means, i),
    ...(submissions[i] && { submission: submissions[i] }),
  }));
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
