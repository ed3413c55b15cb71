// The engine as the case studio uses it: one case, made again whenever it changes.

import * as Comlink from "comlink";
import init, { fileName, Model, pathOf, version, type Losses, type PrimitiveInfo, type Texts, type Thin } from "../generated/engine/engine.js";
import { SAMPLE_OPTIONS } from "../generated/declared/sample-options.js";
import { WRITTEN } from "../shared/roles.mjs";
import { stayAlive } from "./alive";
import { modelOf } from "./input";
import type { ModelFile } from "./protocol";
import type { Base, Case, Cut, Sampling, Vector } from "./case";

/** What making a case takes, roughly. */
export interface Weight {
  readonly points: number;
  readonly seconds: number;
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
  /** Primitives with too few points, where points are as far apart as the case wants them. */
  readonly thin: Thin;
  /** What each cut took away. */
  readonly cuts: readonly Losses[];
}

export interface MadeTruth {
  readonly primitives: readonly PrimitiveInfo[];
  readonly offsets: Uint32Array<ArrayBuffer>;
  readonly indices: Uint32Array<ArrayBuffer>;
}

/** The four files of a case; only the cloud where there is no truth. */
export interface CaseFiles {
  /** What the case is called by every file system. */
  readonly name: string;
  readonly files: readonly ModelFile[];
}

/** The widest spacing that the engine takes. */
const MAX_SPACING = SAMPLE_OPTIONS.find(({ name }) => name === "spacing")?.maximum ?? 1;
/** A case made of fewer points: how many there are for an area of one diagonal squared, in all, and the time they took. */
interface Sparse extends Weight {
  readonly density: number;
}

/** Asked for twice, it would be there twice. */
const ready = init();

/** The points before noise, outliers and cuts, and what they were made of. */
let clean: { readonly of: string; readonly model: Model } | undefined;
let made: Model | undefined;

/** The model is asked for nothing by its name. */
const NAME = "case";

function cleanModel(base: Base, sampling: Sampling): Model {
  // Nothing but noise and outliers depends on the seed of given points.
  const of = base.kind === "files" ? base.source.key : JSON.stringify([base, sampling.spacing, sampling.seed]);
  if (clean?.of === of) return clean.model;
  const model = base.kind === "files" ? readModel(base.source) : generated(base, sampling);
  clean?.model.free();
  clean = { of, model };
  return model;
}

function generated(base: Exclude<Base, { kind: "files" }>, { spacing, seed }: Pick<Sampling, "spacing" | "seed">): Model {
  return base.kind === "blocks" ? Model.compose(NAME, base.blocks.map(mutable), { spacing, seed }) : Model.generate(base.part, { spacing, seed });
}

function readModel({ files }: Extract<Base, { kind: "files" }>["source"]): Model {
  return modelOf(Model, NAME, files.filter(({ method }) => method === undefined));
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

/** The model with noise and outliers, and without what is cut away. The given one stays. */
function finished(clean: Model, { noise, outliers, seed }: Sampling, cuts: readonly Cut[]) {
  let model = clean.degraded({ noise, outliers, seed });
  const { centre, diagonal } = placeOf(model);
  const losses: Losses[] = [];
  for (const cut of cuts) {
    const rest = without(model, cut);
    losses.push(model.losses(rest));
    model.free();
    model = rest;
  }
  return { model, losses, centre, diagonal };
}

const studio = {
  /** Of the engine. */
  async version(): Promise<string> {
    await ready;
    return version();
  },

  /**
   * Told from the same case made twice of fewer points, one in 256 and one in 16: some of the time it takes
   * is the same however many points there are, the rest goes with them. Throws what making it throws.
   */
  async weigh({ base, sampling, cuts }: Case): Promise<Weight> {
    await ready;
    // Points that are given take no making.
    if (base.kind === "files") return { points: 0, seconds: 0 };
    const made = [16, 4].map((wider) => {
      const spacing = Math.min(MAX_SPACING, wider * sampling.spacing);
      const begun = performance.now();
      const whole = generated(base, { ...sampling, spacing });
      const { model } = finished(whole, sampling, cuts);
      const seconds = (performance.now() - begun) / 1000;
      const points = whole.info().points;
      for (const used of [whole, model]) used.free();
      return { density: spacing ** -2, points, seconds };
    });
    const [few, more] = made as [Sparse, Sparse];
    const share = sampling.spacing ** -2 / more.density;
    // The first time code runs it is slow: what seems to take less with more points takes the same.
    const pace = few.density < more.density ? Math.max(0, more.seconds - few.seconds) / (more.density - few.density) : 0;
    return { points: Math.round(more.points * share), seconds: more.seconds + pace * (sampling.spacing ** -2 - more.density) };
  },

  async make({ base, sampling, cuts }: Case): Promise<MadeCase> {
    await ready;
    const { model, losses, centre, diagonal } = finished(cleanModel(base, sampling), sampling, cuts);
    made?.free();
    made = model;
    const positions = model.positionsAround(Float64Array.from(centre)) as Float32Array<ArrayBuffer>;
    const thin = model.thin(sampling.spacing);
    const truth = truthOf(model);
    const buffers = [positions.buffer, ...(truth ? [truth.offsets.buffer, truth.indices.buffer] : [])];
    return Comlink.transfer({ positions, centre, diagonal, truth, thin, cuts: losses }, buffers);
  },

  /** Unit normals of the points of the case made last, as the points around each tell them. */
  normals(): Float32Array {
    const normals = made?.normals() ?? new Float32Array();
    return Comlink.transfer(normals, [normals.buffer]);
  },

  /** The points of the case made last that a ball would cut away. */
  pointsInBall(centre: Vector, radius: number): Uint32Array {
    const inside = made?.pointsInBall(Float64Array.from(centre), radius) ?? new Uint32Array();
    return Comlink.transfer(inside, [inside.buffer]);
  },

  /** Of the case made last. */
  files(wanted: string): CaseFiles {
    if (!made) throw new Error("There is no case yet.");
    const name = fileName(wanted);
    const texts: Partial<Texts> = made.info().hasTruth ? made.write() : { cloud: made.cloud() };
    const files = WRITTEN.flatMap((role): ModelFile[] => {
      const text = texts[role];
      return text === undefined ? [] : [{ path: pathOf("beside", name, role), role, data: new Blob([text], { type: "text/plain" }) }];
    });
    return { name, files };
  },
};

function placeOf(model: Model): { centre: Vector; diagonal: number } {
  const [x = 0, y = 0, z = 0] = model.centre();
  return { centre: [x, y, z], diagonal: model.info().bounds?.diagonal ?? 0 };
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

stayAlive();
Comlink.expose(studio);
