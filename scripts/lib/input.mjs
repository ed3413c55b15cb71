// Files of a model whose content is in memory already.

/** @typedef {import("../../bin/engine/engine.js").InputFile} InputFile */

/**
 * @param {Pick<InputFile, "path" | "role" | "method">} file
 * @param {Uint8Array} bytes
 * @returns {InputFile}
 */
export function held(file, bytes) {
  return { ...file, size: bytes.length, read: () => bytes };
}
