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

/** How distances are sorted into intervals. */
export interface Bins {
  readonly logarithmic: boolean;
  /** Bounds of the intervals, one more than there are. The first interval takes all that is smaller as well. */
  readonly edges: readonly number[];
  readonly of: (distance: number) => number;
}

/** Orders of magnitude below the largest distance that a logarithmic histogram tells apart. */
const DECADES = 6;

/** Intervals of equal length from 0 to `limit`, or of equal ratio from a millionth of it. */
export function binsTo(limit: number, logarithmic: boolean): Bins {
  const top = limit > 0 ? limit : 1;
  const inside = (bin: number) => Math.min(BINS - 1, Math.max(0, bin));
  const steps = Array.from({ length: BINS + 1 }, (_, at) => at / BINS);
  if (!logarithmic) {
    return { logarithmic, edges: steps.map((step) => step * top), of: (distance) => inside(Math.floor((distance / top) * BINS)) };
  }
  const edges = steps.map((step) => top * 10 ** (DECADES * (step - 1)));
  const place = (distance: number) => Math.floor((1 + Math.log10(distance / top) / DECADES) * BINS);
  return { logarithmic, edges, of: (distance) => (distance > 0 ? inside(place(distance)) : 0) };
}

/** Bars of blocks over the intervals. Points without a distance are left out. */
export function blocksOf({ offsets, distances }: SegmentationScene, places: readonly number[], bins: Bins): Block[] {
  const heights = new Uint32Array(BINS);
  const blocks: Block[] = [];
  for (const place of places) {
    const counts = new Uint32Array(BINS);
    for (let at = offsets[place] ?? 0; at < (offsets[place + 1] ?? 0); at++) {
      const distance = distances[at] ?? NaN;
      if (Number.isNaN(distance)) continue;
      const bin = bins.of(distance);
      counts[bin] = (counts[bin] ?? 0) + 1;
    }
    counts.forEach((count, bin) => {
      if (count === 0) return;
      const from = heights[bin] ?? 0;
      heights[bin] = from + count;
      blocks.push({ place, bin, low: bins.edges[bin] ?? 0, high: bins.edges[bin + 1] ?? 0, from, to: from + count });
    });
  }
  return blocks;
}
