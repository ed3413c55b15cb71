// Point sets of a painted prediction, and the ways to change them without a pointer.

/** Predicted primitives that can be painted. */
export const PREDICTIONS = ["A", "B", "C", "D"] as const;
export type Prediction = 0 | 1 | 2 | 3;

/** For every point a bit per prediction that lists it. */
export type Painting = Uint8Array;

export function listsOf(painting: Painting): Uint32Array[] {
  return PREDICTIONS.map((_, bit) =>
    Uint32Array.from([...painting.keys()].filter((point) => (painting[point] ?? 0) & (1 << bit))),
  );
}

export function paintingOf(points: number, lists: readonly (ArrayLike<number> | undefined)[]): Painting {
  const painting = new Uint8Array(points);
  lists.forEach((list, bit) => {
    for (const point of Array.from(list ?? [])) painting[point] = (painting[point] ?? 0) | (1 << bit);
  });
  return painting;
}

export function put(painting: Painting, points: ArrayLike<number>, prediction: Prediction, listed: boolean): Painting {
  const next = painting.slice();
  const bit = 1 << prediction;
  for (const point of Array.from(points)) next[point] = listed ? (next[point] ?? 0) | bit : (next[point] ?? 0) & ~bit;
  return next;
}

/** The neighbours of every point, for growing a selection by a ring. Quadratic: for a lesson's few points. */
export function neighboursOf(positions: Float32Array, reach: number): readonly (readonly number[])[] {
  const count = positions.length / 3;
  const near = Array.from({ length: count }, () => [] as number[]);
  for (let a = 0; a < count; a += 1) {
    for (let b = a + 1; b < count; b += 1) {
      const dx = (positions[3 * a] ?? 0) - (positions[3 * b] ?? 0);
      const dy = (positions[3 * a + 1] ?? 0) - (positions[3 * b + 1] ?? 0);
      const dz = (positions[3 * a + 2] ?? 0) - (positions[3 * b + 2] ?? 0);
      if (dx * dx + dy * dy + dz * dz <= reach * reach) {
        near[a]?.push(b);
        near[b]?.push(a);
      }
    }
  }
  return near;
}

type Near = ReturnType<typeof neighboursOf>;

function listed(painting: Painting, prediction: Prediction): (point: number) => boolean {
  return (point) => ((painting[point] ?? 0) & (1 << prediction)) !== 0;
}

/** Lists every neighbour of a listed point; an empty list begins with the first point. */
export function grown(painting: Painting, near: Near, prediction: Prediction): Painting {
  const is = listed(painting, prediction);
  const now = [...painting.keys()].filter(is);
  const more = now.length > 0 ? now.flatMap((point) => near[point] ?? []) : [0, ...(near[0] ?? [])];
  return put(painting, more, prediction, true);
}

/** Takes away every listed point with a neighbour that is not listed. */
export function shrunk(painting: Painting, near: Near, prediction: Prediction): Painting {
  const is = listed(painting, prediction);
  const rim = [...painting.keys()].filter((point) => is(point) && near[point]?.some((other) => !is(other)));
  return put(painting, rim, prediction, false);
}

/** Moves the list by one point along x: each listed point hands on to its neighbour farthest that way. */
export function shifted(painting: Painting, near: Near, positions: Float32Array, prediction: Prediction, way: 1 | -1): Painting {
  const is = listed(painting, prediction);
  const x = (point: number) => way * (positions[3 * point] ?? 0);
  const now = [...painting.keys()].filter(is);
  const next = now.map((point) =>
    (near[point] ?? []).reduce((best, other) => (x(other) > x(best) ? other : best), point),
  );
  return put(put(painting, now, prediction, false), next, prediction, true);
}
