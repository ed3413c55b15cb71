// Points from a fixed direction, as pixels: for pictures too many and too small for a view of the graphics card each.

/** Where it is looked from: to the right of the front and above, as technical pictures of parts have it. In radians. */
const [ASIDE, ABOVE] = [0.6, 0.5];
/** Of the picture's shorter side, what stays free on each side. */
const MARGIN = 0.04;

export interface Flat {
  readonly width: number;
  readonly height: number;
  /** Pixels a point is wide. */
  readonly dot: number;
}

/**
 * Red, green, blue and opacity of each pixel: points of which the nearest hides the others, transparent where there is none.
 * `colours` has three bytes for each label.
 */
export function flatPicture(positions: Float32Array, labels: Uint32Array, colours: Uint8Array, { width, height, dot }: Flat): Uint8ClampedArray<ArrayBuffer> {
  const pixels = new Uint8ClampedArray(4 * width * height);
  const words = new Uint32Array(pixels.buffer);
  const inks = inksOf(colours);
  const count = positions.length / 3;
  const [across, up, depth] = [new Float32Array(count), new Float32Array(count), new Float32Array(count)];
  const [sinA, cosA, sinB, cosB] = [Math.sin(ASIDE), Math.cos(ASIDE), Math.sin(ABOVE), Math.cos(ABOVE)];
  let [left, right, low, high] = [Infinity, -Infinity, Infinity, -Infinity];
  for (let point = 0; point < count; point += 1) {
    const [x, y, z] = [positions[3 * point] ?? 0, positions[3 * point + 1] ?? 0, positions[3 * point + 2] ?? 0];
    const [side, away] = [cosA * x + sinA * y, cosA * y - sinA * x];
    const lifted = cosB * z + sinB * away;
    across[point] = side;
    up[point] = lifted;
    depth[point] = cosB * away - sinB * z;
    [left, right, low, high] = [Math.min(left, side), Math.max(right, side), Math.min(low, lifted), Math.max(high, lifted)];
  }
  if (count === 0) return pixels;
  const free = 2 * MARGIN * Math.min(width, height) + dot;
  const scale = Math.min((width - free) / Math.max(right - left, Number.MIN_VALUE), (height - free) / Math.max(high - low, Number.MIN_VALUE));
  const usable = Number.isFinite(scale) ? scale : 0;
  const nearest = new Float32Array(width * height).fill(Infinity);
  for (let point = 0; point < count; point += 1) {
    const x = Math.round(width / 2 + usable * ((across[point] ?? 0) - (left + right) / 2) - dot / 2);
    const y = Math.round(height / 2 - usable * ((up[point] ?? 0) - (low + high) / 2) - dot / 2);
    const ink = inks[labels[point] ?? 0] ?? 0;
    const far = depth[point] ?? 0;
    for (let row = Math.max(y, 0); row < Math.min(y + dot, height); row += 1) {
      for (let column = Math.max(x, 0); column < Math.min(x + dot, width); column += 1) {
        const at = row * width + column;
        if (far >= (nearest[at] ?? 0)) continue;
        nearest[at] = far;
        words[at] = ink;
      }
    }
  }
  return pixels;
}

/** The four bytes of a pixel of each label, as one number in the order of this machine. */
function inksOf(colours: Uint8Array): Uint32Array {
  const bytes = new Uint8Array(4 * Math.floor(colours.length / 3)).fill(255);
  for (let label = 0; 4 * label < bytes.length; label += 1) bytes.set(colours.subarray(3 * label, 3 * label + 3), 4 * label);
  return new Uint32Array(bytes.buffer);
}
