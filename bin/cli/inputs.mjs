// Files, folders and zips as one list of things that can be read when their turn comes.

import { closeSync, openSync, readFileSync, readSync, readdirSync, realpathSync, statSync } from "node:fs";
import { join } from "node:path";
import { Damaged } from "../../www/shared/zip/source.mjs";
import { STREAMED, isZip, listZip } from "../../www/shared/zip/zip.mjs";
import { openArrayFiles } from "./hdf5.mjs";
import { whyUnread } from "./reasons.mjs";

/**
 * A file, or an entry of a zip.
 * @typedef {object} File
 * @property {string} path
 * @property {number} size in bytes
 * @property {() => Uint8Array} read gives its content; throws with a reason for the reader
 * @property {(from: number, to: number) => Uint8Array} [part] gives the bytes between two offsets, where they can be had
 *   without the others
 */

/** @typedef {import("../engine/engine.js").DiagnosticInfo} Diagnostic */

/** More files than any collection of point clouds has: a wrong folder was given. */
const MOST_FILES = 200_000;

/**
 * Lists what lies behind the paths, sorted, each file once, and tells what could not be listed.
 * Nothing is read but the directories of zips and HDF5 files.
 * @param {readonly string[]} paths
 */
export async function collect(paths) {
  /** @type {Listing} */
  const listing = { files: new Map(), diagnostics: [] };
  for (const path of paths) {
    attempt(path, listing);
  }
  const { files, told } = await openArrayFiles([...listing.files.values()]);
  const diagnostics = [...listing.diagnostics, ...told.map(({ path, severity, message }) => unusable(path, message, "", severity))];
  return { files: files.sort(byPath), diagnostics };
}

/** @typedef {{ files: Map<string, File>, diagnostics: Diagnostic[] }} Listing by what tells one file from another */

/**
 * A diagnostic in the engine's form about a whole file.
 * @param {string} file
 * @param {string} message
 * @param {string} hint
 * @param {Diagnostic["severity"]} severity
 * @returns {Diagnostic}
 */
export function unusable(file, message, hint = "", severity = "error") {
  return { severity, file, message, found: "", expected: "", hint };
}

/**
 * @param {string} path
 * @param {Listing} listing
 */
function attempt(path, listing) {
  try {
    visit(path, listing);
  } catch (error) {
    listing.diagnostics.push(unusable(path, whyUnread(error)));
  }
}

/**
 * @param {string} path
 * @param {Listing} listing
 */
function visit(path, listing) {
  const about = statSync(path);
  if (about.isDirectory()) {
    visitFolder(path, listing);
    return;
  }
  if (!about.isFile()) {
    throw new Error("it is neither a file nor a folder");
  }
  const key = realpathSync(path);
  if (listing.files.has(key)) {
    return;
  }
  if (listing.files.size >= MOST_FILES) {
    throw new Error(`there are more than ${MOST_FILES} files`);
  }
  if (isZip(path)) {
    visitZip(path, key, about.size, listing);
  } else {
    listing.files.set(key, {
      ...{ path, size: about.size, read: readable(() => readFileSync(path)) },
      part: readable((/** @type {number} */ from, /** @type {number} */ to) => readPart(path, from, to)),
    });
  }
}

/**
 * @param {string} path
 * @param {string} key
 * @param {number} size
 * @param {Listing} listing
 */
function visitZip(path, key, size, { files, diagnostics }) {
  const { entries, problems } = listZip({ size, bytes: (from, to) => readPart(path, from, to) }, STREAMED);
  for (const entry of entries) {
    const [read, part] = [readable(entry.read), readable(entry.part)];
    files.set(`${key}\0${entry.path}`, { path: `${path}/${entry.path}`, size: entry.size, read, part });
  }
  for (const { path: at, severity, message } of problems) {
    diagnostics.push(unusable(`${path}/${at}`, message, "", severity));
  }
}

/**
 * @param {string} folder
 * @param {Listing} listing
 */
function visitFolder(folder, listing) {
  for (const entry of readdirSync(folder, { withFileTypes: true })) {
    const path = join(folder, entry.name);
    // Links to folders are not followed, so that no loop can arise; nor are hidden folders, which
    // are a tool's own affair.
    const skipped = entry.isDirectory() && entry.name.startsWith(".");
    const linked = entry.isSymbolicLink() && isFolder(path);
    if (!skipped && !linked) {
      attempt(path, listing);
    }
  }
}

/** @param {string} path */
function isFolder(path) {
  return statSync(path, { throwIfNoEntry: false })?.isDirectory() ?? false;
}

/**
 * The same with a reason for the reader where it fails.
 * @template {unknown[]} A
 * @param {(...of: A) => Uint8Array} read
 * @returns {(...of: A) => Uint8Array}
 */
function readable(read) {
  return (...of) => {
    try {
      return read(...of);
    } catch (error) {
      throw error instanceof Damaged ? error : new Error(whyUnread(error));
    }
  };
}

/**
 * @param {string} path
 * @param {number} from
 * @param {number} to
 */
function readPart(path, from, to) {
  const bytes = new Uint8Array(to - from);
  const file = openSync(path, "r");
  try {
    for (let filled = 0; filled < bytes.length; ) {
      const got = readSync(file, bytes, filled, bytes.length - filled, from + filled);
      if (got === 0) {
        throw new Error("it became shorter while it was read");
      }
      filled += got;
    }
  } finally {
    closeSync(file);
  }
  return bytes;
}

/** @param {File} a @param {File} b */
function byPath({ path: a }, { path: b }) {
  return a < b ? -1 : a > b ? 1 : 0;
}
