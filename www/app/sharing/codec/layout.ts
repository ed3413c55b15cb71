// What the versions of a link lay out alike, and where they differ. Both sides are frozen: a change of
// layout needs a new version, whose own parts stand in its own file.

import type { FitRequest } from "../../../worker/protocol";
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

/** How a version lays out what others lack or have otherwise. */
export interface Layout {
  readonly sides: readonly NonNullable<SharedView["primitive"]>["side"][];
  /** Fields of the view that there are, as bits of its mask. */
  readonly viewFields: number;
  readonly readPublic: (from: ByteReader) => SharedOrigin;
  /** How each of so many claims was fitted. */
  readonly readFitted: (from: ByteReader, claims: number) => readonly (FitRequest | undefined)[];
}

export function readLayout(layout: Layout, bytes: Uint8Array<ArrayBuffer>): SharedResults {
  const from = new ByteReader(bytes);
  const engine = from.text();
  const protocol = oneOf(PROTOCOLS, from.u8());
  const models = readModels(layout, from);
  const claims = readClaims(layout, from, models.length);
  const view = readView(layout, from, models.length);
  from.end();
  return { engine, protocol, models, claims, ...(view && { view }) };
}

function readModels(layout: Layout, from: ByteReader): SharedModel[] {
  const places = range(from.count(MAX_MODELS));
  const names = places.map(() => from.text());
  const points = places.map(() => from.whole(MAX_NUMBER));
  const truths = places.map(() => from.whole(MAX_NUMBER));
  const kinds = places.map(() => oneOf(ORIGINS, from.u8()));
  const samples = kinds.map((kind) => (kind === "sample" ? readSample(from) : undefined));
  const origins = kinds.map((kind, i): SharedOrigin => samples[i] ?? (kind === "public" ? layout.readPublic(from) : { kind: "files" }));
  const inputs = readFingerprints(from, places.length);
  return places.map((i) => ({
    name: at(names, i),
    points: at(points, i),
    truth: at(truths, i),
    origin: at(origins, i),
    ...(inputs[i] && { inputs: inputs[i] }),
  }));
}

function readClaims(layout: Layout, from: ByteReader, models: number): Claim[] {
  const methods = range(from.count(MAX_CLAIMS)).map(() => from.text());
  const places = range(from.count(MAX_CLAIMS));
  const claimed = places.map(() => from.whole());
  const named = places.map(() => from.whole());
  const predicted = places.map(() => from.whole(MAX_NUMBER));
  const typeErrors = places.map(() => from.whole(MAX_NUMBER));
  const present = places.map(() => from.whole(ALL_PRESENT));
  const fitted = layout.readFitted(from, places.length);
  const submissions = readFingerprints(from, places.length);
  const means = readMeans(from, present);
  return places.map((i) => ({
    model: below(at(claimed, i), models),
    method: at(methods, at(named, i)),
    predicted: at(predicted, i),
    typeErrors: at(typeErrors, i),
    mean: at(means, i),
    ...(fitted[i] && { fitted: fitted[i] }),
    ...(submissions[i] && { submission: submissions[i] }),
  }));
}

function readView(layout: Layout, from: ByteReader, models: number): SharedView | undefined {
  if (from.u8() === 0) return undefined;
  const model = below(from.whole(), models);
  const mask = from.u8() & layout.viewFields;
  return {
    model,
    ...(mask & 1 && { method: from.text() }),
    ...(mask & 2 && { primitive: { side: oneOf(layout.sides, from.u8()), index: from.whole(MAX_NUMBER) } }),
    ...(mask & 4 && { camera: readCamera(from) }),
    ...(mask & 8 && { colour: from.text() }),
    ...(mask & 16 && { arrangement: from.text() }),
    ...(mask & 32 && { left: from.text() }),
    ...(mask & 64 && { rightIsTruth: true }),
  };
}
