// From a list of files to models, grouped by their names and read one at a time.

import { readInputs, unusable } from "./inputs.mjs";

/** Whether a placed file is the cloud or of the ground truth, and no method's. */
export const isOfTruth = ({ method }) => method === undefined;

/**
 * Reads each model among the files, in the engine's order, hands it to `visit(model, inputs, place)`
 * with what it was read from and its place in the row for the terminal, and releases it. Only the
 * files that `wanted` says yes to are read; the overrides say, by path, what is known better about a
 * file than its name tells. Gives the diagnostics of files that belong to no model or could not be
 * read. What `visit` throws ends the run.
 */
export function eachModel(engine, files, { wanted = () => true, overrides = {}, progress = () => {} }, visit) {
  const grouping = engine.group(files.map(({ path }) => path), overrides);
  const diagnostics = grouping.unplaced.map(({ path, reason }) => unusable(path, reason, "", "warning"));
  const byPath = new Map(files.map((file) => [file.path, file]));
  grouping.models.forEach((group, index) => {
    const place = `${index + 1} of ${grouping.models.length}: ${group.name}`;
    progress(place);
    const inputs = readInputs(group.files.filter(wanted), byPath, diagnostics);
    const model = engine.Model.read(group.name, inputs);
    try {
      visit(model, inputs, place);
    } finally {
      model.free();
    }
  });
  return diagnostics;
}
