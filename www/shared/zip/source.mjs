// @ts-check
// Where the bytes of a zip come from: a place that can be read anywhere, so that nothing is held that
// is not asked for.

/**
 * @typedef {object} Source
 * @property {number} size in bytes
 * @property {(from: number, to: number) => Uint8Array} bytes those from `from` to before `to`, both
 *   within the size; throws where they cannot be had
 */

/**
 * Bytes that are in memory already.
 * @param {Uint8Array} all
 * @returns {Source}
 */
export function memory(all) {
  return { size: all.length, bytes: (from, to) => all.subarray(from, to) };
}

/** The zip is none, or is damaged; the message says so of "it". */
export class Damaged extends Error {}

/**
 * A piece of the source as a view, with the checks of `DataView`: reading beyond its end throws.
 * @param {Source} source
 * @param {number} from
 * @param {number} to
 */
export function viewOf(source, from, to) {
  if (!(from >= 0 && from <= to && to <= source.size)) {
    throw new RangeError("beyond the end");
  }
  const { buffer, byteOffset, byteLength } = source.bytes(from, to);
  return new DataView(buffer, byteOffset, byteLength);
}
