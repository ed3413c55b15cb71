// @ts-check
// One entry of a zip: found, unpacked and checked. Layout: PKWARE, APPNOTE.TXT, section 4.3.7.

import { Inflate } from "fflate";
import { crc32 } from "../crc32.mjs";
import { FLAGS } from "./directory.mjs";
import { Damaged, viewOf } from "./source.mjs";

/** @typedef {import("./source.mjs").Source} Source */
/** @typedef {import("./directory.mjs").Header} Header */

const LOCAL = { signature: 0x04034b50, size: 30 };
const STORED = 0;
const DEFLATED = 8;
/** Packed bytes that are unpacked at a time: what they come to is within 66 MiB. */
const PIECE_BYTES = 1 << 16;
/** Deflate makes at most this of one byte: 258 bytes of two bits (RFC 1951, section 3.2.5). */
const MOST_GROWTH = 1032;

/**
 * The content of an entry, as long as the directory says and with its checksum; else it throws
 * `Damaged`. Takes as much memory as that and no more, whatever the packed bytes hold.
 * @param {Source} source
 * @param {Header} header
 */
export function readEntry(source, header) {
  const { from, deflated } = contentOf(source, header);
  const content = deflated ? inflated(source, from, header) : stored(source, from, header);
  if (crc32(content) !== header.checksum) {
    throw new Damaged("it is damaged: its checksum is not that of the zip's directory");
  }
  return content;
}

/**
 * Where the packed bytes of an entry begin, and whether they are deflated or as they are. Throws `Damaged` where they
 * are neither, or the entry is not there.
 * @param {Source} source
 * @param {Header} header
 */
export function contentOf(source, header) {
  const { flags, method, packed, unpacked } = header;
  if (flags & FLAGS.encrypted) {
    throw new Damaged("it is encrypted; unpack the zip first");
  }
  if (method !== STORED && method !== DEFLATED) {
    throw new Damaged(`it cannot be unpacked: compression method ${method} is not known; unpack the zip first`);
  }
  const from = contentAt(source, header);
  if (method === STORED && packed !== unpacked) {
    throw wrongLength(packed > unpacked ? "more" : "less");
  }
  if (method === DEFLATED && unpacked > packed * MOST_GROWTH) {
    throw wrongLength("less");
  }
  return { from, deflated: method === DEFLATED };
}

/**
 * @param {Source} source
 * @param {number} from
 * @param {Header} header
 */
function stored(source, from, { packed }) {
  return source.bytes(from, from + packed);
}

/**
 * @param {Source} source
 * @param {number} from
 * @param {Header} header
 */
function inflated(source, from, { packed, unpacked }) {
  const content = new Uint8Array(unpacked);
  let filled = 0;
  const inflate = new Inflate((chunk) => {
    if (filled + chunk.length > unpacked) {
      throw wrongLength("more");
    }
    content.set(chunk, filled);
    filled += chunk.length;
  });
  const end = from + packed;
  for (let at = from; at < end; at += PIECE_BYTES) {
    push(inflate, source.bytes(at, Math.min(at + PIECE_BYTES, end)), at + PIECE_BYTES >= end);
  }
  if (filled < unpacked) {
    throw wrongLength("less");
  }
  return content;
}

/**
 * @param {Inflate} inflate
 * @param {Uint8Array} piece
 * @param {boolean} last
 */
function push(inflate, piece, last) {
  try {
    inflate.push(piece, last);
  } catch (error) {
    if (error instanceof Damaged) {
      throw error;
    }
    throw new Damaged(`it cannot be unpacked: ${error instanceof Error ? error.message : String(error)}`);
  }
}

/** @param {"more" | "less"} what */
function wrongLength(what) {
  return new Damaged(`it is damaged: it holds ${what} than the zip's directory says`);
}

/**
 * Where the packed bytes begin.
 * @param {Source} source
 * @param {Header} header
 */
function contentAt(source, { flags, packed, unpacked, offset }) {
  let view;
  try {
    view = viewOf(source, offset, offset + LOCAL.size);
  } catch (error) {
    if (!(error instanceof RangeError)) {
      throw error;
    }
  }
  const at = view && offset + LOCAL.size + view.getUint16(26, true) + view.getUint16(28, true);
  if (!view || at === undefined || view.getUint32(0, true) !== LOCAL.signature || at + packed > source.size) {
    throw new Damaged("it is listed in the zip but not there");
  }
  // The entry states its sizes too, unless they follow it or do not fit (all bits set: zip64).
  const stated = [view.getUint32(18, true), view.getUint32(22, true)];
  const known = (view.getUint16(6, true) | flags) & FLAGS.sizesFollow ? [] : [packed, unpacked];
  if (known.some((size, which) => stated[which] !== size && stated[which] !== 0xffffffff)) {
    throw new Damaged("it is damaged: its own header states other sizes than the zip's directory");
  }
  return at;
}
