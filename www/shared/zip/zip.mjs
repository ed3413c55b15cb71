// @ts-check
// The files in a zip, one at a time, with limits that keep a malicious one harmless.

import { readDirectory } from "./directory.mjs";
import { readEntry } from "./entry.mjs";
import { partsOf } from "./parts.mjs";
import { Damaged, memory } from "./source.mjs";

/** @typedef {import("./source.mjs").Source} Source */
/** @typedef {import("./directory.mjs").Header} Header */

/**
 * @typedef {object} Limits
 * @property {number} entryBytes most that one file may unpack to
 * @property {number} totalBytes most that all files together may unpack to
 * @property {number} entries most files in the zip and those within it
 * @property {number} depth zips within zips that are opened: 1 for none but the outermost
 */

/**
 * @typedef {object} Entry
 * @property {string} path within the zip; `inner.zip/name` within a zip in it
 * @property {number} size of its content in bytes
 * @property {() => Uint8Array} read unpacks it; throws `Damaged` with what is wrong
 * @property {(from: number, to: number) => Uint8Array} part unpacks the bytes from one offset to before another, in order
 *   of offsets without ever holding the others; throws as `read`
 */

/** @typedef {{ path: string, severity: "error" | "warning", message: string }} Problem */

/**
 * Where the files are read one after the other and let go. The largest file is what the engine
 * reads at most.
 * @type {Limits}
 */
export const STREAMED = { entryBytes: 512 * 2 ** 20, totalBytes: 4 * 2 ** 30, entries: 100_000, depth: 2 };

/**
 * Where all files are held unpacked together; the whole public repository comes to a fifth.
 * @type {Limits}
 */
export const HELD = { ...STREAMED, totalBytes: 2 ** 30 };

/**
 * Lists the files of a zip and of the zips in it, and what is wrong with it. Nothing is unpacked
 * before it is read, save zips within. Linear in the number of entries. Throws `Damaged` where the
 * source is no zip, or its directory is damaged.
 * @param {Source} source
 * @param {Limits} limits
 */
export function listZip(source, limits) {
  const listing = new Listing(limits);
  listing.open("", source, 1);
  return { entries: listing.affordable(), problems: listing.problems };
}

class Listing {
  /** By path: of two entries of one name the later one takes the place. @type {Map<string, Entry>} */
  #entries = new Map();
  /** @type {Problem[]} */
  problems = [];

  /** @param {Limits} limits */
  constructor(limits) {
    this.limits = limits;
    this.bytesLeft = limits.totalBytes;
    this.entriesLeft = limits.entries;
  }

  /**
   * @param {string} folder
   * @param {Source} source
   * @param {number} depth
   */
  open(folder, source, depth) {
    const headers = readDirectory(source, this.entriesLeft);
    this.entriesLeft -= headers.length;
    for (const header of headers) {
      if (!header.name.endsWith("/")) {
        this.#take(folder + header.name, source, header, depth);
      }
    }
  }

  /**
   * The files in their order, without the largest of those that together are too much: so the
   * others are not lost to them.
   */
  affordable() {
    const refused = new Set();
    for (const entry of [...this.#entries.values()].sort((a, b) => a.size - b.size)) {
      if (!this.#afford(entry.path, entry.size)) {
        refused.add(entry.path);
      }
    }
    return [...this.#entries.values()].filter(({ path }) => !refused.has(path));
  }

  /**
   * @param {string} path
   * @param {Source} source
   * @param {Header} header
   * @param {number} depth
   */
  #take(path, source, header, depth) {
    const { entryBytes } = this.limits;
    if (header.unpacked > entryBytes) {
      this.#tell(path, `it is too large to be unpacked: more than ${mebibytes(entryBytes)}`);
    } else if (isZip(path)) {
      this.#openWithin(path, source, header, depth);
    } else {
      if (this.#entries.has(path)) {
        this.#tell(path, "the zip holds several files of this name; the last is used", "warning");
      }
      this.#entries.set(path, { path, size: header.unpacked, read: () => readEntry(source, header), part: partsOf(source, header) });
    }
  }

  /**
   * Whether so many more bytes are within the limit, and if so counts them.
   * @param {string} path
   * @param {number} size
   */
  #afford(path, size) {
    if (size > this.bytesLeft) {
      this.#tell(path, `it is not unpacked: with smaller files the zip comes to more than ${mebibytes(this.limits.totalBytes)}`);
      return false;
    }
    this.bytesLeft -= size;
    return true;
  }

  /**
   * @param {string} path
   * @param {Source} source
   * @param {Header} header
   * @param {number} depth
   */
  #openWithin(path, source, header, depth) {
    if (depth >= this.limits.depth) {
      this.#tell(path, "a zip within a zip within a zip is not opened");
      return;
    }
    if (!this.#afford(path, header.unpacked)) {
      return;
    }
    try {
      this.open(`${path}/`, memory(readEntry(source, header)), depth + 1);
    } catch (error) {
      if (!(error instanceof Damaged)) {
        throw error;
      }
      this.#tell(path, error.message);
    }
  }

  /**
   * @param {string} path
   * @param {string} message
   * @param {Problem["severity"]} severity
   */
  #tell(path, message, severity = "error") {
    this.problems.push({ path, severity, message });
  }
}

/** @param {string} path */
export function isZip(path) {
  return /\.zip$/i.test(path);
}

/** @param {number} bytes */
function mebibytes(bytes) {
  return `${bytes / 2 ** 20} MiB`;
}
