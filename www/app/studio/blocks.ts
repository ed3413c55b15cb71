// What can be done to a list of blocks.

import type { ShapeInfo } from "../../generated/engine/engine.js";
import type { Block, Vector } from "./case";

/** A block to begin with. */
export function blockOf({ name, defaults }: ShapeInfo): Block {
  return { operation: "add", shape: name, sizes: [...defaults], position: [0, 0, 0], rotation: [0, 0, 0] };
}

/** The block as another shape; sizes of one name are kept. */
export function reshaped(block: Block, before: ShapeInfo | undefined, after: ShapeInfo): Block {
  const kept = (size: string) => block.sizes[before?.sizes.indexOf(size) ?? -1];
  return { ...block, shape: after.name, sizes: after.defaults.map((value, at) => kept(after.sizes[at] ?? "") ?? value) };
}

export function replaced<T>(all: readonly T[], place: number, by: T): T[] {
  return all.map((each, at) => (at === place ? by : each));
}

export function removed<T>(all: readonly T[], place: number): T[] {
  return all.filter((_, at) => at !== place);
}

export function inserted<T>(all: readonly T[], place: number, item: T): T[] {
  return [...all.slice(0, place), item, ...all.slice(place)];
}

/** One element a place up (-1) or down (1); the same where there is no such place. */
export function moved<T>(all: readonly T[], place: number, by: -1 | 1): readonly T[] {
  const item = all[place];
  const to = place + by;
  if (item === undefined || to < 0 || to >= all.length) return all;
  return inserted(removed(all, place), to, item);
}

export function withAxis([x, y, z]: Vector, axis: number, value: number): Vector {
  const next: [number, number, number] = [x, y, z];
  next[axis] = value;
  return next;
}
