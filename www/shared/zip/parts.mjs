// @ts-check
// An entry of a zip a part at a time, unpacked from its beginning as far as it is asked for.

import { Inflate } from "fflate";
import { crc32 } from "../crc32.mjs";
import { contentOf } from "./entry.mjs";
import { Damaged } from "./source.mjs";

/** @typedef {import("./source.mjs").Source} Source */
/** @typedef {import("./directory.mjs").Header} Header */

/** Packed bytes that are unpacked at a time: what they come to is within 17 MiB. */
const PIECE_BYTES = 1 << 14;

/**
 * What gives the bytes of an entry's content from one offset to before another. Whoever reads forwards has it unpacked
 * once, and no more of it is held than was asked for last; whoever goes back has it begun anew. Throws `Damaged` where
 * the content is not as the directory says, which its checksum tells at the end.
 * @param {Source} source
 * @param {Header} header
 */
export function partsOf(source, header) {
  /** @type {Forwards | undefined} */
  let forwards;
  /** @param {number} from @param {number} to */
  return (from, to) => {
    if (forwards === undefined || from < forwards.start) {
      forwards = new Forwards(source, header);
    }
    return forwards.part(from, to);
  };
}

class Forwards {
  /** Offset of what is held. */
  start = 0;
  /** @type {Uint8Array[]} */
  #held = [];
  /** Where what is held ends. */
  #end = 0;
  #sum = 0;
  #packed;
  #at = 0;
  #inflate;

  /**
   * @param {Source} source
   * @param {Header} header
   */
  constructor(source, header) {
    const { from, deflated } = contentOf(source, header);
    this.header = header;
    this.#packed = (/** @type {number} */ at, /** @type {number} */ to) => source.bytes(from + at, from + to);
    this.#inflate = deflated ? new Inflate((chunk) => this.#take(chunk)) : undefined;
  }

  /**
   * @param {number} from
   * @param {number} to
   */
  part(from, to) {
    this.#letGo(from);
    while (this.#end < to && this.#at < this.header.packed) {
      this.#unpack();
      this.#letGo(from);
    }
    if (this.#end < to) {
      throw new Damaged("it is damaged: it holds less than the zip's directory says");
    }
    const bytes = new Uint8Array(to - from);
    let at = this.start;
    for (const chunk of this.#held) {
      const [first, last] = [Math.max(from, at), Math.min(to, at + chunk.length)];
      if (first < last) bytes.set(chunk.subarray(first - at, last - at), first - from);
      at += chunk.length;
    }
    return bytes;
  }

  /** @param {number} before */
  #letGo(before) {
    for (let first = this.#held[0]; first && this.start + first.length <= before; first = this.#held[0]) {
      this.start += first.length;
      this.#held.shift();
    }
  }

  #unpack() {
    const { packed } = this.header;
    const to = Math.min(packed, this.#at + PIECE_BYTES);
    const piece = this.#packed(this.#at, to);
    this.#at = to;
    if (this.#inflate === undefined) {
      this.#take(piece);
      return;
    }
    try {
      this.#inflate.push(piece, to === packed);
    } catch (error) {
      if (error instanceof Damaged) throw error;
      throw new Damaged(`it cannot be unpacked: ${error instanceof Error ? error.message : String(error)}`);
    }
  }

  /** @param {Uint8Array} chunk */
  #take(chunk) {
    const { unpacked, checksum } = this.header;
    if (chunk.length === 0) return;
    this.#end += chunk.length;
    if (this.#end > unpacked) {
      throw new Damaged("it is damaged: it holds more than the zip's directory says");
    }
    this.#sum = crc32(chunk, this.#sum);
    if (this.#end === unpacked && this.#sum !== checksum) {
      throw new Damaged("it is damaged: its checksum is not that of the zip's directory");
    }
    this.#held.push(chunk);
  }
}
