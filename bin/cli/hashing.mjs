// The SHA-256 of files, taken while they are read: whole, or piece by piece from their beginning.

import { createHash } from "node:crypto";

/** @typedef {import("./inputs.mjs").File} File */

/** Bytes read at a time of what nobody has asked for. */
const PIECE_BYTES = 2 ** 22;

export class Hashes {
  /** By path, of the files that were read whole. @type {Map<string, string>} */
  #whole = new Map();
  /** By path, of those read in pieces: what was read from the beginning without a gap. @type {Map<string, Sum>} */
  #inPieces = new Map();

  /**
   * The same file, heard while it is read.
   * @param {File} file
   * @returns {File}
   */
  heard(file) {
    const { path, part } = file;
    /** @type {File} */
    const heard = {
      ...file,
      read: () => {
        const bytes = file.read();
        this.#whole.set(path, createHash("sha256").update(bytes).digest("hex"));
        return bytes;
      },
    };
    if (part) {
      heard.part = (from, to) => {
        const bytes = part(from, to);
        const sum = this.#inPieces.get(path) ?? new Sum(file);
        this.#inPieces.set(path, sum);
        sum.take(from, bytes);
        return bytes;
      };
    }
    return heard;
  }

  /**
   * In hexadecimal digits; undefined of a file that was not read.
   * @param {string} path
   */
  of(path) {
    const whole = this.#whole.get(path) ?? this.#inPieces.get(path)?.finish();
    if (whole !== undefined) {
      this.#whole.set(path, whole);
      this.#inPieces.delete(path);
    }
    return whole;
  }

  clear() {
    this.#whole.clear();
    this.#inPieces.clear();
  }
}

class Sum {
  #hash = createHash("sha256");
  #end = 0;

  /** @param {File} file */
  constructor(file) {
    this.file = file;
  }

  /**
   * @param {number} from
   * @param {Uint8Array} bytes
   */
  take(from, bytes) {
    const to = from + bytes.length;
    if (from <= this.#end && this.#end < to) {
      this.#hash.update(bytes.subarray(this.#end - from));
      this.#end = to;
    }
  }

  /** Reads what is left; undefined where it cannot be had any more. */
  finish() {
    const { size, part } = this.file;
    try {
      while (part && this.#end < size) {
        const from = this.#end;
        this.take(from, part(from, Math.min(size, from + PIECE_BYTES)));
      }
    } catch {
      return undefined;
    }
    return this.#hash.digest("hex");
  }
}
