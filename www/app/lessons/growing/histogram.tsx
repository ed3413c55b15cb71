// How many points have which surface variation, on a logarithmic scale, and the threshold.

import type { JSX } from "preact";
import { SEQUENTIAL, sample } from "../../view/palette";

const BINS = 48;
const WIDTH = 480;
const HEIGHT = 160;
const FOOT = 24;
/** Smaller variations share the first bin; none is larger than a third. */
export const SMALLEST = 1e-5;
const LARGEST = 1 / 3;

/** Place of a variation on the scale, 0 to 1. */
export function place(value: number): number {
  const share = Math.log(Math.max(value, SMALLEST) / SMALLEST) / Math.log(LARGEST / SMALLEST);
  return Math.min(1, Math.max(0, share));
}

export function Histogram({ values, threshold, sharp }: { values: Float32Array; threshold: number; sharp: number }): JSX.Element {
  const counts = new Array<number>(BINS).fill(0);
  for (const value of values) {
    const bin = Math.min(BINS - 1, Math.floor(place(value) * BINS));
    counts[bin] = (counts[bin] ?? 0) + 1;
  }
  const most = Math.max(1, ...counts);
  const x = place(threshold) * WIDTH;
  return (
    <svg
      class="histogram"
      viewBox={`0 0 ${WIDTH} ${HEIGHT}`}
      role="img"
      aria-label={`Histogram of the surface variation; ${sharp} of ${values.length} points lie above the threshold of ${threshold.toPrecision(2)}`}
    >
      {counts.map((count, bin) => {
        const height = (Math.sqrt(count) / Math.sqrt(most)) * (HEIGHT - FOOT - 12);
        return (
          <rect
            key={bin}
            x={(bin / BINS) * WIDTH + 1}
            y={HEIGHT - FOOT - height}
            width={WIDTH / BINS - 2}
            height={height}
            fill={sample(SEQUENTIAL, (bin + 0.5) / BINS)}
            stroke="var(--line-strong)"
            stroke-width="0.5"
          />
        );
      })}
      <line class="threshold" x1={x} x2={x} y1={0} y2={HEIGHT - FOOT} />
      {[1e-5, 1e-4, 1e-3, 1e-2, 1e-1].map((value) => (
        <text key={value} x={Math.max(24, place(value) * WIDTH)} y={HEIGHT - 8} text-anchor="middle">
          {value}
        </text>
      ))}
    </svg>
  );
}
