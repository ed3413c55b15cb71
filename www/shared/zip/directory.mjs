// @ts-check
// The directory of a zip, read once. Layout: PKWARE, APPNOTE.TXT, sections 4.3.12 to 4.3.16 and 4.5.3.
//
// fflate's own reading walks the whole directory for every entry, which grows with the square of
// their number (16,000 entries took half a minute), and takes the last mark of an end for the end.

import { Damaged, viewOf } from "./source.mjs";

/** @typedef {import("./source.mjs").Source} Source */

/**
 * What the directory says of an entry.
 * @typedef {object} Header
 * @property {string} name
 * @property {number} flags bits of {@link FLAGS}
 * @property {number} method of compression
 * @property {number} checksum CRC-32 of the content
 * @property {number} packed bytes in the zip
 * @property {number} unpacked bytes of the content
 * @property {number} offset of the entry's own header
 */

export const FLAGS = { encrypted: 1, sizesFollow: 1 << 3, utf8: 1 << 11 };

const END = { signature: 0x06054b50, size: 22, mostComment: 0xffff };
const END64_LOCATOR = { signature: 0x07064b50, size: 20 };
const END64 = { signature: 0x06064b50, size: 56 };
const HEADER = { signature: 0x02014b50, size: 46 };
const ZIP64_FIELD = 1;
/** Stands for a size or offset that is in the zip64 field. */
const ELSEWHERE = 0xffffffff;

/**
 * The headers of all entries, at most `mostEntries`. Linear in the directory's length. Throws
 * `Damaged` where there is no sound directory, or one of more entries.
 * @param {Source} source
 * @param {number} mostEntries
 * @returns {Header[]}
 */
export function readDirectory(source, mostEntries) {
  const place = findDirectory(source);
  if (place === undefined) {
    throw new Damaged("it is no zip, or a damaged one: its directory cannot be read");
  }
  if (place.count > mostEntries) {
    throw new Damaged(`it holds more than ${mostEntries} files`);
  }
  try {
    return headers(viewOf(source, place.from, place.to), place.count);
  } catch (error) {
    if (error instanceof RangeError) {
      throw new Damaged("it is no zip, or a damaged one: its directory cannot be read");
    }
    throw error;
  }
}

/** @typedef {{ count: number, from: number, to: number }} Place */

/**
 * Where the directory is. The mark of its end may also stand in the comment behind it, so a mark
 * counts only where a directory begins where it says; and one whose comment ends with the file
 * comes before one with other bytes behind it.
 * @param {Source} source
 * @returns {Place | undefined}
 */
function findDirectory(source) {
  const start = Math.max(0, source.size - END.size - END.mostComment);
  const tail = viewOf(source, start, source.size);
  /** @type {Place | undefined} */
  let loose;
  for (let at = tail.byteLength - END.size; at >= 0; at -= 1) {
    if (tail.getUint32(at, true) !== END.signature) {
      continue;
    }
    const place = soundPlace(source, tail, at, start);
    if (place === undefined) {
      continue;
    }
    if (at + END.size + tail.getUint16(at + 20, true) === tail.byteLength) {
      return place;
    }
    loose ??= place;
  }
  return loose;
}

/**
 * The place that the mark at `at` of the tail gives, if a directory is there.
 * @param {Source} source
 * @param {DataView} tail
 * @param {number} at
 * @param {number} start of the tail
 */
function soundPlace(source, tail, at, start) {
  const [count, size, from] = [tail.getUint16(at + 10, true), tail.getUint32(at + 12, true), tail.getUint32(at + 16, true)];
  try {
    const place = place64(source, start + at) ?? { count, from, to: from + size };
    const begins = place.count === 0 || viewOf(source, place.from, place.from + 4).getUint32(0, true) === HEADER.signature;
    return begins && place.to <= start + at && place.count * HEADER.size <= place.to - place.from ? place : undefined;
  } catch (error) {
    if (error instanceof RangeError) {
      return undefined;
    }
    throw error;
  }
}

/**
 * @param {Source} source
 * @param {number} end where the end of the directory begins
 * @returns {Place | undefined}
 */
function place64(source, end) {
  if (end < END64_LOCATOR.size) {
    return undefined;
  }
  const locator = viewOf(source, end - END64_LOCATOR.size, end);
  if (locator.getUint32(0, true) !== END64_LOCATOR.signature) {
    return undefined;
  }
  const at = uint64(locator, 8);
  const record = viewOf(source, at, at + END64.size);
  expect(record, 0, END64);
  const from = uint64(record, 48);
  return { count: uint64(record, 32), from, to: from + uint64(record, 40) };
}

/**
 * @param {DataView} view of the directory
 * @param {number} count
 */
function headers(view, count) {
  /** @type {Header[]} */
  const found = [];
  let at = 0;
  for (let left = count; left > 0; left -= 1) {
    expect(view, at, HEADER);
    const nameAt = at + HEADER.size;
    const extraAt = nameAt + view.getUint16(at + 28, true);
    const extraEnd = extraAt + view.getUint16(at + 30, true);
    const flags = view.getUint16(at + 8, true);
    const [unpacked, packed, offset] = withZip64(
      [view.getUint32(at + 24, true), view.getUint32(at + 20, true), view.getUint32(at + 42, true)],
      view,
      extraAt,
      extraEnd,
    );
    const [method, checksum] = [view.getUint16(at + 10, true), view.getUint32(at + 16, true)];
    found.push({ name: nameOf(view, nameAt, extraAt, flags), flags, method, checksum, packed, unpacked, offset });
    at = extraEnd + view.getUint16(at + 32, true);
  }
  return found;
}

/**
 * @param {DataView} view
 * @param {number} from
 * @param {number} to
 * @param {number} flags
 */
function nameOf(view, from, to, flags) {
  if (to > view.byteLength) {
    throw new RangeError("a name is cut off");
  }
  const bytes = new Uint8Array(view.buffer, view.byteOffset + from, to - from);
  return new TextDecoder(flags & FLAGS.utf8 ? "utf-8" : "latin1").decode(bytes);
}

/**
 * The sizes and offset with those that do not fit in 32 bits taken from the zip64 field, in order.
 * @param {[number, number, number]} values
 * @param {DataView} view
 * @param {number} from
 * @param {number} end
 * @returns {[number, number, number]}
 */
export function withZip64(values, view, from, end) {
  if (!values.includes(ELSEWHERE)) {
    return values;
  }
  let at = from;
  while (at + 4 <= end && view.getUint16(at, true) !== ZIP64_FIELD) {
    at += 4 + view.getUint16(at + 2, true);
  }
  if (at + 4 > end) {
    throw new RangeError("no zip64 field");
  }
  at -= 4;
  /** @param {number} value */
  const whole = (value) => (value === ELSEWHERE ? uint64(view, (at += 8)) : value);
  return [whole(values[0]), whole(values[1]), whole(values[2])];
}

/**
 * @param {DataView} view
 * @param {number} at
 */
function uint64(view, at) {
  return Number(view.getBigUint64(at, true));
}

/**
 * @param {DataView} view
 * @param {number} at
 * @param {{ signature: number }} what
 */
function expect(view, at, { signature }) {
  if (view.getUint32(at, true) !== signature) {
    throw new RangeError("another signature");
  }
}
