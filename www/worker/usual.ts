// Where a scale of distances ends: few points lie far off, and by those alone all others would look the same.

/** This share of the points lies on the scale, the rest beyond its end. */
const SHARE = 0.95;
/** So many of them, evenly taken, tell as much as all. */
const SAMPLE = 100_000;

/** The distance within which most points lie; NaN are no distances, and 0 is for none. */
export function usualDistance(distances: Float32Array): number {
  const step = Math.max(1, Math.ceil(distances.length / SAMPLE));
  const sample = new Float32Array(Math.ceil(distances.length / step));
  let count = 0;
  for (let at = 0; at < distances.length; at += step) {
    const distance = distances[at] ?? NaN;
    if (!Number.isNaN(distance)) sample[count++] = distance;
  }
  return sample.subarray(0, count).sort()[Math.floor(SHARE * (count - 1))] ?? 0;
}
