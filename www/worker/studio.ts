// The engine as the case studio uses it: one case, made again whenever it changes.

import * as Comlink from "comlink";
import init, { Model, parts, shapes, type PartInfo, type PrimitiveInfo, type ShapeInfo } from "../generated/engine/engine.js";
import type { Base, Case, Cut, Sampling, Vector } from "../app/studio/case";

/** What can be built with. */
export interface Stock {
  readonly shapes: readonly ShapeInfo[];
  readonly parts: readonly PartInfo[];
}

/** What a cut took away. */
export interface CutEffect {
  readonly points: number;
  /** Numbers of the primitives that lost their last point. */
  readonly vanished: readonly number[];
}

/** A case ready to be looked at. */
export interface MadeCase {
  /** x y z per point, relative to `centre`. */
  readonly positions: Float32Array<ArrayBuffer>;
  /** That of the cloud before anything is cut away, so that cuts move nothing. */
  readonly centre: Vector;
  /** Of that cloud's box. */
  readonly diagonal: number;
  /** Nothing where there is no truth. */
  readonly truth: MadeTruth | undefined;
  readonly cuts: readonly CutEffect[];
}

export interface MadeTruth {
  readonly primitives: readonly PrimitiveInfo[];
  readonly offsets: Uint32Array<ArrayBuffer>;
  readonly indices: Uint32Array<ArrayBuffer>;
}

/** The texts of the four files; only the cloud where there is no truth. */
export interface CaseTexts {
  readonly cloud: string;
  readonly truth: { readonly primitives: string; readonly parametric: string; readonly implicit: string } | undefined;
}

/** Asked for twice, it would be there twice. */
const ready = init();

/** The points before noise, outliers and cuts, and what they were made of. */
let clean: { readonly of: string; readonly model: Model } | undefined;
let made: Model | undefined;

/** The model is asked for nothing by its name. */
const NAME = "case";

async function cleanModel(base: Base, { spacing, seed }: Sampling): Promise<Model> {
  // Nothing but noise and outliers depends on the seed of given points.
  const of = base.kind === "files" ? base.source.key : JSON.stringify([base, spacing, seed]);
  if (clean?.of === of) return clean.model;
  const model =
    base.kind === "blocks"
      ? Model.compose(NAME, base.blocks.map(mutable), { spacing, seed })
      : base.kind === "sample"
        ? Model.generate(base.part, { spacing, seed })
        : await readModel(base.source);
  clean?.model.free();
  clean = { of, model };
  return model;
}

async function readModel({ files }: Extract<Base, { kind: "files" }>["source"]): Promise<Model> {
  const own = files.filter(({ method }) => method === undefined);
  const read = own.map(async ({ path, role, data }) => ({ path, role, bytes: new Uint8Array(await data.arrayBuffer()) }));
  return Model.read(NAME, await Promise.all(read));
}

/** The declared types of the boundary are mutable. */
function mutable({ operation, shape, sizes, position, rotation }: Extract<Base, { kind: "blocks" }>["blocks"][number]) {
  return { operation, shape, sizes: [...sizes], position: xyz(position), rotation: xyz(rotation) };
}

function xyz([x, y, z]: Vector): [number, number, number] {
  return [x, y, z];
}

function without(model: Model, cut: Cut): Model {
  if (cut.kind === "ball") return model.withoutBall(Float64Array.from(cut.centre), cut.radius);
  const camera = Float64Array.from([...cut.target, ...cut.rotation, cut.eye, cut.depth]);
  return model.withoutLasso(camera, Float64Array.from(cut.corners.flat()));
}

function numbersOf(model: Model): number[] {
  return model.info().hasTruth ? model.primitives().map(({ number }) => number) : [];
}

const studio = {
  async stock(): Promise<Stock> {
    await ready;
    return { shapes: shapes(), parts: parts() };
  },

  async make({ base, sampling, cuts }: Case): Promise<MadeCase> {
    await ready;
    const { noise, outliers, seed } = sampling;
    let model = (await cleanModel(base, sampling)).degraded({ noise, outliers, seed });
    const { centre, diagonal } = placeOf(model);
    const effects: CutEffect[] = [];
    for (const cut of cuts) {
      const rest = without(model, cut);
      const left = new Set(numbersOf(rest));
      effects.push({
        points: model.info().points - rest.info().points,
        vanished: numbersOf(model).filter((number) => !left.has(number)),
      });
      model.free();
      model = rest;
    }
    made?.free();
    made = model;
    const positions = positionsOf(model, centre);
    const truth = truthOf(model);
    const buffers = [positions.buffer, ...(truth ? [truth.offsets.buffer, truth.indices.buffer] : [])];
    return Comlink.transfer({ positions, centre, diagonal, truth, cuts: effects }, buffers);
  },

  /** Of the case made last. */
  texts(): CaseTexts {
    if (!made) throw new Error("There is no case yet.");
    return made.info().hasTruth ? withTruth(made) : { cloud: made.cloud(), truth: undefined };
  },
};

function withTruth(model: Model): CaseTexts {
  const { cloud = "", primitives, parametric, implicit } = model.write();
  return { cloud, truth: { primitives, parametric, implicit } };
}

function placeOf(model: Model): { centre: Vector; diagonal: number } {
  const [x = 0, y = 0, z = 0] = model.centre();
  const { bounds } = model.info();
  const sides = bounds ? [0, 1, 2].map((axis) => (bounds.max[axis] ?? 0) - (bounds.min[axis] ?? 0)) : [];
  return { centre: [x, y, z], diagonal: Math.hypot(...sides) };
}

/** The points relative to a place other than the middle of what is left of them. */
function positionsOf(model: Model, centre: Vector): Float32Array<ArrayBuffer> {
  const positions = model.positions() as Float32Array<ArrayBuffer>;
  const own = model.centre();
  const shift = centre.map((coordinate, axis) => (own[axis] ?? 0) - coordinate);
  if (shift.every((by) => by === 0)) return positions;
  return positions.map((value, at) => value + (shift[at % 3] ?? 0));
}

function truthOf(model: Model): MadeTruth | undefined {
  if (!model.info().hasTruth) return undefined;
  const { offsets, indices } = model.members();
  return {
    primitives: model.primitives(),
    offsets: offsets as Uint32Array<ArrayBuffer>,
    indices: indices as Uint32Array<ArrayBuffer>,
  };
}

export type StudioWorker = typeof studio;

Comlink.expose(studio);
