// The case the studio begins with, and what holds for every case.

import type { Block, Case, Sampling, Vector } from "../../worker/case";

export type { Ball, Base, Block, Case, Cut, Lasso, Sampling, Vector } from "../../worker/case";

export const MAX_BLOCKS = 64;

/** The median of the benchmark's clouds, as for all samples. */
export const SAMPLING: Sampling = { spacing: 0.0077, noise: 0, outliers: 0, seed: 1 };

const block = (operation: Block["operation"], shape: string, sizes: readonly number[], position: Vector): Block => ({
  operation,
  shape,
  sizes,
  position,
  rotation: [0, 0, 0],
});

/** Something to begin with: a rounded plate with a boss and a bore. */
export const FIRST: Case = {
  name: "case",
  base: {
    kind: "blocks",
    blocks: [
      block("add", "rounded", [80, 50, 12, 10], [0, 0, 6]),
      block("add", "cone", [18, 13, 26], [0, 0, 25]),
      block("cut", "cylinder", [7, 60], [0, 0, 20]),
    ],
  },
  sampling: { ...SAMPLING, spacing: 0.012 },
  cuts: [],
};

/** Whether the case can be made again from what a link can hold. */
export function isGenerated({ base }: Case): boolean {
  return base.kind !== "files";
}
