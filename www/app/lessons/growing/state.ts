// What the lesson on primitive growing holds: a part, its surface variation and partition, and what
// the engine says of the region that was chosen.

import { batch, signal } from "@preact/signals";
import type { PartitionInfo, SlippageInfo, SplitInfo } from "../../../generated/engine/engine.js";
import type { LessonModel, LessonSegmentation } from "../../../worker/lessons";
import { latest } from "../../engine/latest";
import type { Session } from "../session";

const PART = "bracket";
/** Fine enough for its plates to have faces between their edges. */
const SAMPLE = { spacing: 0.012, noise: 0, seed: 1 };
/** Marks a sharp point in labels and steps. */
export const SHARP = 2 ** 32 - 1;
/** The paper's range of η, and one that suits this part. */
export const ETA = { least: 0.65, most: 0.95, first: 0.7 } as const;
/** Regions of fewer points are crumbs between edges. */
export const CRUMB = 30;

export const part = signal<LessonModel | undefined>(undefined);
export const variation = signal<Float32Array>(new Float32Array());
export const eta = signal<number>(ETA.first);
export const partition = signal<PartitionInfo | undefined>(undefined);
/** Steps of growth that are shown. */
export const grown = signal(0);
export const region = signal<number | undefined>(undefined);
export const slippage = signal<SlippageInfo | undefined>(undefined);
export const motion = signal(0);
export const amount = signal(0);
export const ghost = signal<Float32Array>(new Float32Array());
export const pieces = signal<readonly SplitInfo[] | undefined>(undefined);
export const segmentation = signal<LessonSegmentation | undefined>(undefined);
export const busy = signal(false);

/** Loads the part; nothing of an earlier visit is left. */
export async function open({ engine }: Session): Promise<void> {
  busy.value = true;
  batch(() => {
    part.value = undefined;
    variation.value = new Float32Array();
    segmentation.value = undefined;
    show(undefined);
  });
  try {
    const model = await engine.part(PART, SAMPLE);
    const values = await engine.grow();
    const first = await engine.partition(eta.value);
    batch(() => {
      part.value = model;
      variation.value = values;
      show(first);
    });
  } finally {
    busy.value = false;
  }
}

function show(next: PartitionInfo | undefined): void {
  batch(() => {
    partition.value = next;
    region.value = undefined;
    slippage.value = undefined;
    pieces.value = undefined;
    ghost.value = new Float32Array();
    grown.value = 0;
  });
}

export function thresholder({ engine }: Session): (next: number) => Promise<void> {
  return latest(async (next: number) => show(await engine.partition(next)));
}

/** The most steps that any region takes to grow. */
export function lastStep(): number {
  return (partition.value?.steps ?? new Uint32Array()).reduce((most, each) => (each === SHARP ? most : Math.max(most, each)), 0);
}

export async function choose({ engine }: Session, next: number): Promise<void> {
  const found = await engine.slippage(next);
  batch(() => {
    region.value = next;
    slippage.value = found;
    pieces.value = undefined;
    motion.value = 0;
    amount.value = 0;
    ghost.value = new Float32Array();
  });
}

export function mover({ engine }: Session): () => Promise<void> {
  const ask = latest(async ([of, which, by]: readonly [number, number, number]) => {
    ghost.value = by === 0 ? new Float32Array() : await engine.ghost(of, which, by);
  });
  return () => (region.value === undefined ? Promise.resolve() : ask([region.value, motion.value, amount.value]));
}

export async function split({ engine }: Session): Promise<void> {
  if (region.value === undefined) return;
  busy.value = true;
  try {
    pieces.value = await engine.split(region.value);
  } finally {
    busy.value = false;
  }
}

export async function segment({ engine }: Session): Promise<void> {
  busy.value = true;
  try {
    segmentation.value = await engine.segment("pg");
  } finally {
    busy.value = false;
  }
}
