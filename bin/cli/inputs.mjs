// Files, folders and zips as one list of things that can be read when their turn comes.

import { readFileSync, readdirSync, realpathSync, statSync } from "node:fs";
import { join } from "node:path";
import { listZip } from "./zip.mjs";

/** More files than any collection of point clouds has: a wrong folder was given. */
const MOST_FILES = 200_000;
/** Largest file that is read at all; the engine has finer limits of its own. */
const MOST_BYTES = 1 << 30;

/**
 * Lists what lies behind the paths, sorted, each file once: `{ files, diagnostics }`, where a file
 * is `{ path, read() }` and `read` gives its bytes or throws.
 */
export function collect(paths) {
  const files = new Map();
  const diagnostics = [];
  for (const path of paths) {
    try {
      visit(path, files, diagnostics);
    } catch (error) {
      diagnostics.push(unusable(path, reason(error)));
    }
  }
  return { files: [...files.values()].sort(byPath), diagnostics };
}

/** The content of a model's files for `Model.read`; what cannot be read is told and left out. */
export function readInputs(files, byPath, diagnostics) {
  const inputs = [];
  for (const { path, role, method } of files) {
    try {
      inputs.push({ path, role, method, bytes: byPath.get(path).read() });
    } catch (error) {
      diagnostics.push(unusable(path, reason(error)));
    }
  }
  return inputs;
}

/** A diagnostic in the engine's form about a whole file. */
export function unusable(file, message, hint = "", severity = "error") {
  return { severity, file, message, found: "", expected: "", hint };
}

/** What the operating system said, in words. */
export function reason(error) {
  const words = {
    ENOENT: "there is no such file or folder",
    EACCES: "reading it is not permitted",
    EPERM: "reading it is not permitted",
    ELOOP: "it is a loop of links",
    EISDIR: "it is a folder",
  };
  return words[error.code] ?? error.message;
}

function visit(path, files, diagnostics) {
  const about = statSync(path);
  if (about.isDirectory()) {
    visitFolder(path, files, diagnostics);
    return;
  }
  if (!about.isFile()) {
    throw new Error("it is neither a file nor a folder");
  }
  const key = realpathSync(path);
  if (files.has(key)) {
    return;
  }
  if (files.size >= MOST_FILES) {
    throw new Error(`there are more than ${MOST_FILES} files`);
  }
  const read = () => readWhole(path, about.size);
  if (!/\.zip$/i.test(path)) {
    files.set(key, { path, read });
    return;
  }
  const listing = listZip(read());
  for (const entry of listing.entries) {
    files.set(`${key}\0${entry.path}`, { path: `${path}/${entry.path}`, read: entry.read });
  }
  for (const { path: at, message } of listing.problems) {
    diagnostics.push(unusable(join(path, at), message));
  }
}

function visitFolder(folder, files, diagnostics) {
  const entries = readdirSync(folder, { withFileTypes: true });
  for (const entry of entries) {
    const path = join(folder, entry.name);
    // Links to folders are not followed, so that no loop can arise; nor are hidden folders, which
    // are a tool's own affair.
    const skipped = entry.isDirectory() && entry.name.startsWith(".");
    const linked = entry.isSymbolicLink() && isFolder(path);
    if (skipped || linked) {
      continue;
    }
    try {
      visit(path, files, diagnostics);
    } catch (error) {
      diagnostics.push(unusable(path, reason(error)));
    }
  }
}

function isFolder(path) {
  try {
    return statSync(path).isDirectory();
  } catch {
    return false;
  }
}

function readWhole(path, size) {
  if (size > MOST_BYTES) {
    throw new Error(`it is larger than ${MOST_BYTES} bytes`);
  }
  return readFileSync(path);
}

function byPath({ path: a }, { path: b }) {
  return a < b ? -1 : a > b ? 1 : 0;
}
