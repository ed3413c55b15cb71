// Lengths and angles between picked points, in the cloud's units.

export type Place = readonly [x: number, y: number, z: number];

export interface Taped {
  /** From the first point to the second, and on to the third. */
  readonly lengths: readonly number[];
  /** Between the way to the middle point and the way on, in degrees: 180 where the three lie in a row. */
  readonly angle?: number;
  /** Of the circle through the three; infinite where they lie in a row. */
  readonly radius?: number;
}

const minus = (a: Place, b: Place): Place => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const length = (a: Place): number => Math.hypot(...a);
const cross = (a: Place, b: Place): Place => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const dot = (a: Place, b: Place): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

/** What two or three places measure; nothing of a single one. */
export function taped(places: readonly Place[]): Taped {
  const [a, b, c] = places;
  if (!a || !b) return { lengths: [] };
  const first = length(minus(b, a));
  if (!c) return { lengths: [first] };
  const [back, on] = [minus(a, b), minus(c, b)];
  const [second, third] = [length(on), length(minus(c, a))];
  const twiceArea = length(cross(back, on));
  return {
    lengths: [first, second],
    // By sine and cosine: an arc cosine has no digits left where the angle is small or straight.
    angle: (Math.atan2(twiceArea, dot(back, on)) * 180) / Math.PI,
    radius: twiceArea > 0 ? (first * second * third) / (2 * twiceArea) : Infinity,
  };
}
