// From a list of files to reports, one model at a time.

import { createHash } from "node:crypto";
import { unusable } from "./inputs.mjs";
import { eachModel, isOfTruth } from "./models.mjs";

/**
 * Scores every submission among the files; with `self`, the truth against itself instead. The
 * overrides say, by path, what is known better about a file than its name tells. Gives
 * `{ results, diagnostics }`: the reports in the engine's order, by model number, name and method,
 * each with the engine's version and the files it was made of.
 */
export function evaluate(engine, files, { protocol, overrides = {}, self = false, progress = () => {} }) {
  const results = [];
  const found = [];
  const version = engine.version();
  const wanted = self ? isOfTruth : undefined;
  const unread = eachModel(engine, files, { wanted, overrides, progress }, (model, inputs) => {
    const { reports, diagnostics } = scoreModel(model, { protocol, self });
    const hashed = inputs.map(hash);
    results.push(
      ...reports.map((report) => ({
        ...report,
        engine: version,
        files: hashed.filter(({ method }) => method === undefined || method === report.method),
      })),
    );
    found.push(...diagnostics);
  });
  return { results, diagnostics: [...unread, ...found] };
}

function hash({ bytes, ...file }) {
  return { ...file, sha256: createHash("sha256").update(bytes).digest("hex") };
}

function scoreModel(model, { protocol, self }) {
  const { name, hasTruth, methods, diagnostics } = model.info();
  const unscored = (...about) => ({ reports: [], diagnostics: [...diagnostics, unusable(name, ...about)] });
  if (!hasTruth) {
    const hint = `Give ${name}_primitives.txt of the benchmark as well`;
    return unscored("there is no ground truth to score against", hint);
  }
  if (!self && methods.length === 0) {
    const hint =
      "Give a method's files in a folder named after it (pointCloud_primitives_MINE), " +
      "or score the truth against itself with --self";
    return unscored("there is no submission to score", hint, "note");
  }
  // No method: the truth itself.
  const submissions = self ? [undefined] : methods;
  return { reports: submissions.map((method) => model.score(method, protocol)), diagnostics };
}
