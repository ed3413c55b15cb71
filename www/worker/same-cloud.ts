// By what one knows that two lists of coordinates are the same cloud, without comparing millions of them on the page.

/** Two different lists have the same one once in 2^64 times. */
export function cloudKey(positions: Float32Array): string {
  const words = new Uint32Array(positions.buffer, positions.byteOffset, positions.length);
  // FNV-1a over whole words, twice: each with a multiplier of its own, and mixed so that high bits come down.
  let one = 0x811c9dc5;
  let other = 0x9e3779b9;
  for (const word of words) {
    one = Math.imul(one ^ word, 0x01000193);
    one ^= one >>> 15;
    other = Math.imul(other ^ word, 0x85ebca6b);
    other ^= other >>> 13;
  }
  return [words.length, one >>> 0, other >>> 0].join(" ");
}
