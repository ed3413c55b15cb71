// What the lesson on the Hough transform holds: a part, a slice of parameter space, and what the
// engine found in it so far.

import { batch, signal } from "@preact/signals";
import { SURFACE_TYPES } from "../../../generated/declared/surface-types.js";
import type { CellInfo, MaximumInfo, PolishInfo, SliceInfo, SurfaceType } from "../../../generated/engine/engine.js";
import type { LessonModel, LessonSegmentation } from "../../../worker/lessons";
import type { Session } from "../session";

export const FAMILIES: readonly SurfaceType[] = SURFACE_TYPES.map(({ name }) => name);

/** A part that has faces of the family, several alike where possible. */
export const PART_OF: Readonly<Record<SurfaceType, "flange" | "ball-joint">> = {
  Plane: "flange",
  Cylinder: "flange",
  Cone: "flange",
  Sphere: "ball-joint",
  Torus: "flange",
};

/** Few enough points to vote while the reader waits, and as noisy as measured ones. */
const SAMPLE = { spacing: 0.02, noise: 0.0005, seed: 1 };

export const family = signal<SurfaceType>("Cylinder");
export const part = signal<LessonModel | undefined>(undefined);
export const slice = signal<SliceInfo | undefined>(undefined);
export const busy = signal(false);

export const point = signal<number | undefined>(undefined);
export const gamma = signal<Uint32Array>(new Uint32Array());
export const cell = signal<number | undefined>(undefined);
export const cellInfo = signal<CellInfo | undefined>(undefined);
/** How many points have voted, and 𝓗 after them. */
export const voted = signal(0);
export const heights = signal<Float32Array>(new Float32Array());
/** 𝓗 when all have voted: its highest cell sets the scale of the pictures. */
export const all = signal<Float32Array>(new Float32Array());
export const share = signal(0.1);
export const maxima = signal<readonly MaximumInfo[]>([]);
export const polished = signal<PolishInfo | undefined>(undefined);
export const segmentation = signal<LessonSegmentation | undefined>(undefined);

let name = "";

export function pointCount(): number {
  return (part.value?.positions.length ?? 0) / 3;
}

/** Points in the order of their votes: scattered over the part, the same every time. */
export function order(count: number): Uint32Array {
  const total = pointCount();
  // A step without a common divisor visits every point once.
  let stride = Math.max(1, Math.round(total * 0.382));
  while (divisor(stride, total) !== 1) stride += 1;
  return Uint32Array.from({ length: Math.min(count, total) }, (_, turn) => (turn * stride) % total);
}

function divisor(a: number, b: number): number {
  return b === 0 ? a : divisor(b, a % b);
}

/** Loads the part of a family and lets the engine prepare the votes of all its points. */
export async function open({ engine }: Session, next: SurfaceType): Promise<void> {
  busy.value = true;
  family.value = next;
  try {
    const wanted = PART_OF[next];
    const model = name === wanted && part.value ? part.value : await engine.part(wanted, SAMPLE);
    name = wanted;
    const info = await engine.vote(next);
    part.value = model;
    const every = await engine.heights(order(pointCount()));
    const found = await engine.maxima(share.value);
    batch(() => {
      slice.value = info;
      all.value = every;
      maxima.value = found;
      forget();
      heights.value = new Float32Array(every.length);
    });
  } finally {
    busy.value = false;
  }
}

/** Clears what the reader has found. */
function forget(): void {
  point.value = cell.value = cellInfo.value = polished.value = segmentation.value = undefined;
  gamma.value = new Uint32Array();
  heights.value = new Float32Array();
  voted.value = 0;
}

/** The same with an engine that has just been started and knows no part yet; nothing of an earlier visit is left. */
export function openAnew(session: Session): Promise<void> {
  name = "";
  batch(() => {
    part.value = slice.value = undefined;
    all.value = new Float32Array();
    maxima.value = [];
    forget();
  });
  return open(session, family.value);
}

export async function choosePoint({ engine }: Session, index: number): Promise<void> {
  const cells = await engine.gamma(index);
  batch(() => {
    point.value = index;
    gamma.value = cells;
  });
}

export async function chooseCell({ engine }: Session, index: number): Promise<void> {
  const info = await engine.cell(index);
  batch(() => {
    cell.value = info && index;
    cellInfo.value = info;
    polished.value = undefined;
  });
}

export async function vote({ engine }: Session, count: number): Promise<void> {
  const asked = Math.min(count, pointCount());
  const next = await engine.heights(order(asked));
  batch(() => {
    voted.value = asked;
    heights.value = next;
  });
}

export async function setShare({ engine }: Session, next: number): Promise<void> {
  const found = await engine.maxima(next);
  batch(() => {
    share.value = next;
    maxima.value = found;
  });
}

export async function polish(session: Session, index: number): Promise<void> {
  await chooseCell(session, index);
  polished.value = await session.engine.polish(index);
}

export async function segment({ engine }: Session): Promise<void> {
  busy.value = true;
  try {
    segmentation.value = await engine.segment("ht");
  } finally {
    busy.value = false;
  }
}
