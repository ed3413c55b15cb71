// How many digits of a place mean something.

import type { Vector } from "./case";

/**
 * A place with as many decimals as points in single precision, relative to the middle of a cloud of this diagonal, tell
 * apart. How far the cloud is from the origin does not matter.
 */
export function rounded([x, y, z]: Vector, diagonal: number): Vector {
  const decimals = Math.min(15, Math.max(0, 7 - Math.ceil(Math.log10(diagonal))));
  const round = (value: number) => Number(value.toFixed(decimals));
  return [round(x), round(y), round(z)];
}
