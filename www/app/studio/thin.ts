// Primitives with so few points that they are none to speak of.

import type { MadeTruth } from "../../worker/studio";

/** Fewer points than these leave open what surface they lie on: a torus alone has seven parameters. */
const FEWEST = 10;

/** Numbers of the primitives that have too few points. */
export function thinIn({ primitives, offsets }: Pick<MadeTruth, "primitives" | "offsets">): number[] {
  return primitives.filter((_, place) => (offsets[place + 1] ?? 0) - (offsets[place] ?? 0) < FEWEST).map(({ number }) => number);
}

/** What is wrong with a generated case of which some primitives have too few points, and what to do; nothing where none has. */
export function thinness(thin: readonly number[], count: number, length: number): string | undefined {
  if (thin.length === 0) return undefined;
  const which = thin.length === 1 ? `Primitive ${thin[0]} has` : `${thin.length} of ${count} primitives have`;
  return (
    `${which} fewer than ${FEWEST} points, too few to tell the surface. Points lie ${Number(length.toPrecision(2))} apart: ` +
    "the spacing is a share of the diagonal of the whole part. Set the blocks closer together, or choose a narrower spacing."
  );
}
