// @ts-check
// What the formats are given, and where its figures come from.

import { oneLine } from "../text.mjs";

/**
 * A file that was read for a report, with the SHA-256 of its bytes in hexadecimal digits; null
 * where it could not be had (browsers hash only on pages that came over a safe connection).
 * @typedef {{ path: string, role: Role, method?: string, sha256: string | null }} HashedFile
 * @typedef {import("../../generated/engine/engine.js").Role} Role
 */

/**
 * A report with what it takes to repeat it: the engine's version and the files it was made of; and
 * whether the engine fitted the submission's surfaces to segments that came without.
 * @typedef {import("../../generated/engine/engine.js").Report & { engine: string, files: HashedFile[], surfacesFitted?: boolean }} Result
 */

/**
 * The figures of a published method on a model: without files, counts and what else was not published.
 * @typedef {Pick<Result, "model" | "method" | "protocol" | "points" | "truth" | "engine" | "files"> & { mean: Partial<Result["mean"]>, predicted: null, type_errors: null, published: true }} PublishedResult
 */

/** What a row of a table is made of. @typedef {(Result & { published?: undefined }) | (PublishedResult & { surfacesFitted?: undefined })} Row */

/**
 * How the results came about, one sentence per engine and protocol among them.
 * @param {readonly Row[]} results
 */
export function provenance(results) {
  const ways = results.map(({ engine, protocol, method, published }) =>
    published
      ? `${oneLine(method)}: the published result files, scored by protocol ${protocol}`
      : `Fit4CAD engine ${oneLine(engine)}, protocol ${protocol}`,
  );
  const fitted = results.filter(({ surfacesFitted }) => surfacesFitted).map(({ method }) => oneLine(method));
  const notes = [...new Set(fitted)].map((method) => `Surfaces of ${method} fitted by the engine to the segments given`);
  return [...new Set(ways), ...notes];
}

/**
 * Each file once, as `sha256sum` lists them: such lines can be handed to `sha256sum --check`.
 * @param {readonly Row[]} results
 */
export function checksums(results) {
  const lines = results.flatMap(({ files }) =>
    files.map(({ path, sha256 }) => `${sha256 ?? "(not hashed)"}  ${oneLine(path)}`),
  );
  return [...new Set(lines)];
}
