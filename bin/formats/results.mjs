// @ts-check
// What the formats are given, and where its figures come from.

/**
 * A file that was read for a report, with the SHA-256 of its bytes in hexadecimal digits; null
 * where it could not be had (browsers hash only on pages that came over a safe connection).
 * @typedef {{ path: string, role: Role, method?: string, sha256: string | null }} HashedFile
 * @typedef {import("../engine/engine.js").Role} Role
 */

/**
 * A report with what it takes to repeat it: the engine's version and the files it was made of.
 * @typedef {import("../engine/engine.js").Report & { engine: string, files: HashedFile[] }} Result
 */

/**
 * How the results came about, one sentence per engine and protocol among them.
 * @param {readonly Result[]} results
 */
export function provenance(results) {
  const ways = results.map(
    ({ engine, protocol }) => `Fit4CAD engine ${oneLine(engine)}, protocol ${protocol}`,
  );
  return [...new Set(ways)];
}

/**
 * Each file once, as `sha256sum` lists them: such lines can be handed to `sha256sum --check`.
 * @param {readonly Result[]} results
 */
export function checksums(results) {
  const lines = results.flatMap(({ files }) =>
    files.map(({ path, sha256 }) => `${sha256 ?? "(not hashed)"}  ${oneLine(path)}`),
  );
  return [...new Set(lines)];
}

/**
 * Names come from files and folders: whatever they hold must not end a line or a comment.
 * @param {string} text
 */
export function oneLine(text) {
  // eslint-disable-next-line no-control-regex -- they are what is removed
  return text.replace(/[\u0000-\u001f\u007f-\u009f\u2028\u2029]/g, "\ufffd");
}
