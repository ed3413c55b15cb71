// Arguments out of bytes, and other bytes of bytes: as `crate/fuzz` does it, for JavaScript.

/** Values at the edges of what there is. */
const SPECIAL = [0, -0, 1, -1, 0.5, 1e-320, 5e-324, 1e30, 1e154, 1e308, -1e308, NaN, Infinity, -Infinity, 2 ** 31, 2 ** 32, 2 ** 53, -(2 ** 31)];
const EDGES = [0, 1, 0x7f, 0x80, 0xff, 0x7fff, 0xffff, 0x7fffffff, 0xffffffff];

/** Bytes read from the front; beyond the end they are zeros. */
export class Bytes {
  #at = 0;

  /** @param {Uint8Array} all */
  constructor(all) {
    this.all = all;
  }

  get isEmpty() {
    return this.#at >= this.all.length;
  }

  byte() {
    this.#at += 1;
    return this.all[this.#at - 1] ?? 0;
  }

  /** @param {number} bound */
  below(bound) {
    return this.byte() % bound;
  }

  /** @template T @param {readonly T[]} of */
  one(of) {
    return /** @type {T} */ (of[this.below(of.length)]);
  }

  number() {
    const tag = this.byte();
    if (tag < 64) return /** @type {number} */ (SPECIAL[tag % SPECIAL.length]);
    if (tag < 128) return (this.byte() * 256 + this.byte()) / 64;
    return tag - 160;
  }

  text() {
    const start = this.#at;
    while (!this.isEmpty && this.all[this.#at] !== 0) this.#at += 1;
    const text = new TextDecoder().decode(this.all.subarray(start, this.#at));
    this.#at += 1;
    return text;
  }

  /**
   * @template T
   * @param {number} most
   * @param {() => T} each
   */
  list(most, each) {
    const count = this.below(most + 1);
    /** @type {T[]} */
    const list = [];
    while (list.length < count && !this.isEmpty) list.push(each());
    return list;
  }

  rest() {
    const rest = this.all.subarray(this.#at);
    this.#at = this.all.length;
    return rest;
  }
}

/**
 * Another input of one, by one to sixteen changes.
 * @param {Uint8Array} input
 * @param {Uint8Array} other
 * @param {() => number} random from 0 to below 1
 * @param {number} longest
 */
export function mutate(input, other, random, longest) {
  /** @param {number} bound */
  const below = (bound) => Math.floor(random() * bound);
  let bytes = [...input];
  do {
    const at = below(bytes.length + 1);
    const end = Math.min(bytes.length, at + below(16));
    switch (below(9)) {
      case 0:
        if (at < bytes.length) bytes[at] = (bytes[at] ?? 0) ^ (1 << below(8));
        break;
      case 1:
        if (at < bytes.length) bytes[at] = below(256);
        break;
      case 2:
        if (at < bytes.length) bytes[at] = ((bytes[at] ?? 0) + below(71) - 35) & 0xff;
        break;
      case 3: {
        const edge = (EDGES[below(EDGES.length)] ?? 0) + below(3) - 1;
        for (let byte = 0; byte < 4 && at + byte < bytes.length; byte += 1) bytes[at + byte] = (edge >> (8 * byte)) & 0xff;
        break;
      }
      case 4:
        bytes.splice(at, 0, ...Array.from({ length: below(9) }, () => below(256)));
        break;
      case 5:
        bytes.splice(at, end - at);
        break;
      case 6:
        bytes.splice(below(bytes.length + 1), 0, ...bytes.slice(at, end));
        break;
      case 7: {
        const from = below(other.length + 1);
        bytes.splice(at, 0, ...other.subarray(from, from + below(32)));
        break;
      }
      default:
        bytes = [...bytes.slice(0, at), ...other.subarray(below(other.length + 1))];
    }
  } while (random() < 0.5);
  return Uint8Array.from(bytes.slice(0, longest));
}
