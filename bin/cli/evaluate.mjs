// From a list of files to reports: groups them into models, reads and scores one model at a time.

import { reason, unusable } from "./inputs.mjs";

/** The name under which `--self` submits the truth. */
export const TRUTH_AS_METHOD = "truth";

/**
 * Scores every submission among the files. Gives `{ reports, diagnostics }`: the reports ordered by
 * model number, then name, then method; the diagnostics in the order in which they were found.
 */
export function evaluate(engine, files, { protocol, self = false, progress = () => {} }) {
  const grouping = engine.group(files.map(({ path }) => path));
  const diagnostics = grouping.unplaced.map(({ path, reason: why }) =>
    unusable(path, why, "", "warning"),
  );
  const byPath = new Map(files.map((file) => [file.path, file]));
  const reports = [];
  grouping.models.forEach((group, index) => {
    progress(`${index + 1} of ${grouping.models.length}: ${group.name}`);
    const inputs = readInputs(group.files, byPath, diagnostics);
    scoreModel(engine, group.name, withSelf(inputs, self), protocol, reports, diagnostics);
  });
  // The engine orders the models; within one, the methods.
  return { reports, diagnostics };
}

function readInputs(files, byPath, diagnostics) {
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

/** The truth once more, as a submission. */
function withSelf(inputs, self) {
  const truth = inputs.filter(({ role, method }) => self && role !== "cloud" && !method);
  return [...inputs, ...truth.map((input) => ({ ...input, method: TRUTH_AS_METHOD }))];
}

function scoreModel(engine, name, inputs, protocol, reports, diagnostics) {
  const model = engine.Model.read(name, inputs);
  try {
    const info = model.info();
    diagnostics.push(...info.diagnostics);
    const where = inputs[0]?.path ?? name;
    if (info.methods.length === 0) {
      diagnostics.push(
        unusable(
          where,
          `${name} has no submission`,
          "Give a method's files in a folder named after it (pointCloud_primitives_MINE), or score the truth itself with --self",
          "note",
        ),
      );
      return;
    }
    if (!info.hasTruth) {
      diagnostics.push(
        unusable(where, `${name} has no ground truth to score against`, `Give ${name}_primitives.txt of the benchmark as well`),
      );
      return;
    }
    for (const method of info.methods) {
      reports.push(model.score(method, protocol));
    }
  } finally {
    model.free();
  }
}
