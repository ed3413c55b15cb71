// From a list of files to reports: groups them into models, reads and scores one model at a time.

import { createHash } from "node:crypto";
import { readInputs, unusable } from "./inputs.mjs";

/**
 * Scores every submission among the files; with `self`, the truth against itself instead. The
 * overrides say, by path, what is known better about a file than its name tells. Gives
 * `{ results, diagnostics }`: the reports in the engine's order, by model number, name and method,
 * each with the engine's version and the files it was made of.
 */
export function evaluate(engine, files, { protocol, overrides = {}, self = false, progress = () => {} }) {
  const grouping = engine.group(files.map(({ path }) => path), overrides);
  const diagnostics = grouping.unplaced.map(({ path, reason: why }) =>
    unusable(path, why, "", "warning"),
  );
  const byPath = new Map(files.map((file) => [file.path, file]));
  const results = [];
  const version = engine.version();
  grouping.models.forEach((group, index) => {
    progress(`${index + 1} of ${grouping.models.length}: ${group.name}`);
    const wanted = group.files.filter(({ method }) => !self || method === undefined);
    const inputs = readInputs(wanted, byPath, diagnostics);
    const scored = scoreModel(engine.Model.read(group.name, inputs), { protocol, self });
    const hashed = inputs.map(hash);
    results.push(
      ...scored.reports.map((report) => ({
        ...report,
        engine: version,
        files: hashed.filter(({ method }) => method === undefined || method === report.method),
      })),
    );
    diagnostics.push(...scored.diagnostics);
  });
  return { results, diagnostics };
}

function hash({ bytes, ...file }) {
  return { ...file, sha256: createHash("sha256").update(bytes).digest("hex") };
}

function scoreModel(model, { protocol, self }) {
  try {
    const { name, hasTruth, methods, diagnostics } = model.info();
    const about = (message, hint, severity) => unusable(name, message, hint, severity);
    if (!hasTruth) {
      const hint = `Give ${name}_primitives.txt of the benchmark as well`;
      const missing = about("there is no ground truth to score against", hint);
      return { reports: [], diagnostics: [...diagnostics, missing] };
    }
    if (!self && methods.length === 0) {
      const hint =
        "Give a method's files in a folder named after it (pointCloud_primitives_MINE), " +
        "or score the truth against itself with --self";
      const missing = about("there is no submission to score", hint, "note");
      return { reports: [], diagnostics: [...diagnostics, missing] };
    }
    // No method: the truth itself.
    const submissions = self ? [undefined] : methods;
    return { reports: submissions.map((method) => model.score(method, protocol)), diagnostics };
  } finally {
    model.free();
  }
}
