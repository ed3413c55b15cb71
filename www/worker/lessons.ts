// The engine as the lessons use it: step by step, on one small model at a time.

import * as Comlink from "comlink";
import init, {
  compareForms,
  GrowingLesson,
  HoughLesson,
  Model,
  surfaceForms,
  type FieldReport,
  type FitMethod,
  type PaintedScore,
  type InputFile,
  type PrimitiveInfo,
  type Report,
  type Role,
  type SampleOptions,
  type SliceInfo,
  type SurfaceSliders,
  type SurfaceType,
} from "../generated/engine/engine.js";
import type { WrittenRole } from "../shared/roles.mjs";
import { stayAlive } from "./alive";

/** Points and what they belong to. */
export interface LessonModel {
  /** x y z per point, relative to the cloud's centre. */
  readonly positions: Float32Array;
  /** Unit normals, as the points around each tell them: by these the view draws the points as a surface. */
  readonly normals: Float32Array;
  readonly lists: PrimitiveLists;
}

export interface PrimitiveLists {
  readonly primitives: readonly PrimitiveInfo[];
  /** The points of each primitive. */
  readonly members: readonly Uint32Array[];
}

export interface LessonSegmentation extends PrimitiveLists {
  readonly report: Report;
}

const FIT_SEED = 1;

let model: Model | undefined;
/** What the model's last fit is called. */
let fitted: string | undefined;
let hough: HoughLesson | undefined;
let growing: GrowingLesson | undefined;

function hold(next: Model): Model {
  hough?.free();
  hough = undefined;
  growing?.free();
  growing = undefined;
  model?.free();
  model = next;
  fitted = undefined;
  return next;
}

function held<T>(value: T | undefined): T {
  if (value === undefined) throw new Error("The lesson has not begun.");
  return value;
}

function listsOf(of: Model, method?: string): PrimitiveLists {
  const { offsets, indices } = of.members(method);
  const primitives = of.primitives(method);
  const members = primitives.map((_, place) => indices.slice(offsets[place], offsets[place + 1]));
  return { primitives, members };
}

function shown(of: Model): LessonModel {
  return { positions: of.positions(), normals: of.normals(), lists: listsOf(of) };
}

const lessons = {
  async niche(rest: number): Promise<LessonModel> {
    await init();
    return shown(hold(Model.niche(rest)));
  },

  paint(lists: Uint32Array[], shift: number): PaintedScore {
    return held(model).paint(lists, shift);
  },

  async part(name: string, options: SampleOptions): Promise<LessonModel> {
    await init();
    return shown(hold(Model.generate(name, options)));
  },

  /** The model of some texts, with noise over its diagonal in each coordinate. */
  async texts(name: string, texts: Readonly<Record<string, string>>, noise: number): Promise<LessonModel> {
    await init();
    const inputs = Object.entries(texts).map(([role, text]): InputFile => {
      const content = new TextEncoder().encode(text);
      return { path: role, role: role as Role, size: content.length, read: () => content };
    });
    const clean = Model.read(name, inputs);
    if (noise === 0) return shown(hold(clean));
    try {
      return shown(hold(clean.degraded({ noise, seed: FIT_SEED })));
    } finally {
      clean.free();
    }
  },

  /** The cloud, and what the last fit found on it, as texts of its four files. */
  found(): Record<WrittenRole, string> {
    const of = held(model);
    const { primitives, parametric, implicit } = of.write(held(fitted));
    return { cloud: of.cloud(), primitives, parametric, implicit };
  },

  field(lists: Uint32Array[]): FieldReport {
    return held(model).fieldOf(lists);
  },

  vote(family: SurfaceType): SliceInfo {
    hough?.free();
    hough = undefined;
    hough = new HoughLesson(held(model), family);
    return hough.slice();
  },

  gamma(point: number): Uint32Array {
    return held(hough).gamma(point);
  },

  heights(points: Uint32Array): Float32Array {
    return held(hough).heights(points);
  },

  cell(cell: number) {
    return held(hough).cell(cell);
  },

  maxima(share: number) {
    return held(hough).maxima(share);
  },

  polish(cell: number) {
    return held(hough).polish(cell);
  },

  grow(): Float32Array {
    growing?.free();
    growing = undefined;
    growing = new GrowingLesson(held(model));
    return growing.variation();
  },

  partition(quantile: number) {
    return held(growing).partition(quantile);
  },

  slippage(region: number) {
    return held(growing).slippage(region);
  },

  ghost(region: number, motion: number, amount: number): Float32Array {
    return held(growing).ghost(region, motion, amount);
  },

  split(region: number) {
    return held(growing).split(region);
  },

  segment(method: FitMethod): LessonSegmentation {
    const of = held(model);
    const name = of.fit(method, {}, FIT_SEED, () => undefined);
    fitted = name;
    return { ...listsOf(of, name), report: of.score(name, "definition") };
  },

  async forms(sliders: SurfaceSliders) {
    await init();
    return surfaceForms(sliders);
  },

  async compare(predicted: number[], truth: number[]) {
    await init();
    return compareForms(Float64Array.from(predicted), Float64Array.from(truth));
  },
};

export type LessonsWorker = typeof lessons;

stayAlive();
Comlink.expose(lessons);
