// Writing files whole or not at all.

import { randomUUID } from "node:crypto";
import { mkdirSync, renameSync, rmSync, statSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { whyUnwritten } from "./reasons.mjs";

/** A file could not be written; the message names it and says why. */
export class NotWritten extends Error {}

/**
 * Writes a file under its name only once it is complete, and makes its folder if missing: a full
 * disk or an end in the middle leaves what was there before. Throws `NotWritten`.
 * @param {string} path
 * @param {string | Uint8Array} content
 */
export function writeWhole(path, content) {
  // Threads, processes and machines may write into one folder at once.
  const part = join(dirname(path), `.fit4cad-${randomUUID()}.part`);
  try {
    makeFolders(dirname(path));
    try {
      writeFileSync(part, content, { flag: "wx" });
      renameSync(part, path);
    } catch (error) {
      rmSync(part, { force: true });
      throw error;
    }
  } catch (error) {
    throw notWritten(path, error);
  }
}

/**
 * Makes a folder that files are to go to, if missing. Throws `NotWritten`.
 * @param {string} path
 */
export function makeFolder(path) {
  try {
    makeFolders(path);
  } catch (error) {
    throw notWritten(path, error);
  }
}

/**
 * Makes a folder and those it is in, where missing. Not by `recursive`: Node never returns from that where
 * a folder that is there takes none, such as /proc.
 * @param {string} path
 */
function makeFolders(path) {
  if (statSync(path, { throwIfNoEntry: false })?.isDirectory()) return;
  const parent = dirname(path);
  if (parent !== path) makeFolders(parent);
  try {
    mkdirSync(path);
  } catch (error) {
    // Another process may have been quicker.
    if (!statSync(path, { throwIfNoEntry: false })?.isDirectory()) throw error;
  }
}

/**
 * @param {string} path
 * @param {unknown} error
 */
function notWritten(path, error) {
  return new NotWritten(`${path} could not be written: ${whyUnwritten(error)}`);
}

/**
 * What keeps something from being written, in words; nothing where it is written.
 * @param {() => void} write throws `NotWritten`
 */
export function problemOf(write) {
  try {
    write();
    return undefined;
  } catch (error) {
    if (error instanceof NotWritten) {
      return error.message;
    }
    throw error;
  }
}
