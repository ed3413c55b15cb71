// Distances to surfaces, counted for a histogram.

import type { SegmentationScene } from "../../worker/protocol";

export const BINS = 24;

/** Points of one primitive whose distances lie in one interval, on top of those of the primitives before it. */
export interface Block {
  readonly place: number;
  readonly bin: number;
  /** Bounds of the interval; the upper one belongs to it in the last bin alone. */
  readonly low: number;
  readonly high: number;
  /** Number of points below this block in its bar, and with it. */
  readonly from: number;
  readonly to: number;
}

/** Largest distance of the wanted primitives' points; 0 where there is none. */
export function largest({ offsets, distances }: SegmentationScene, places: readonly number[]): number {
  let found = 0;
  for (const place of places) {
    for (let at = offsets[place] ?? 0; at < (offsets[place + 1] ?? 0); at++) {
      const distance = distances[at] ?? NaN;
      if (distance > found) found = distance;
    }
  }
  return found;
}

/** Bars of blocks over `BINS` intervals of 0 to `limit`. Points without a distance are left out. */
export function blocksOf({ offsets, distances }: SegmentationScene, places: readonly number[], limit: number): Block[] {
  const heights = new Uint32Array(BINS);
  const blocks: Block[] = [];
  for (const place of places) {
    const counts = new Uint32Array(BINS);
    for (let at = offsets[place] ?? 0; at < (offsets[place + 1] ?? 0); at++) {
      const distance = distances[at] ?? NaN;
      if (Number.isNaN(distance)) continue;
      const bin = limit > 0 ? Math.min(BINS - 1, Math.floor((distance / limit) * BINS)) : 0;
      counts[bin] = (counts[bin] ?? 0) + 1;
    }
    counts.forEach((count, bin) => {
      if (count === 0) return;
      const from = heights[bin] ?? 0;
      heights[bin] = from + count;
      blocks.push({ place, bin, low: (limit * bin) / BINS, high: (limit * (bin + 1)) / BINS, from, to: from + count });
    });
  }
  return blocks;
}
