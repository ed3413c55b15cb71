// Primitives with so few points that they are none to speak of, in words.

import type { MadeCase } from "../../worker/studio";

/** What is wrong with a generated case of which some primitives have too few points, and what to do; nothing where none has. */
export function thinness({ primitives, fewest, distance }: MadeCase["thin"], count: number): string | undefined {
  if (primitives.length === 0) return undefined;
  const which = primitives.length === 1 ? `Primitive ${primitives[0]} has` : `${primitives.length} of ${count} primitives have`;
  return (
    `${which} fewer than ${fewest} points, too few to tell the surface. Points lie ${Number(distance.toPrecision(2))} apart: ` +
    "the spacing is a share of the diagonal of the whole part. Set the blocks closer together, or choose a narrower spacing."
  );
}
