// From a list of files to models, grouped by their names and read one at a time.

import { readInputs, unusable } from "./inputs.mjs";

/**
 * Reads each model among the files, hands it to `visit(model, inputs)` with what it was read from,
 * and releases it. With `truthOnly` the files of methods are left out. Gives the diagnostics of
 * files that belong to no model or could not be read.
 */
export function eachModel(engine, files, { truthOnly = false, progress = () => {} }, visit) {
  const grouping = engine.group(files.map(({ path }) => path));
  const diagnostics = grouping.unplaced.map(({ path, reason: why }) =>
    unusable(path, why, "", "warning"),
  );
  const byPath = new Map(files.map((file) => [file.path, file]));
  grouping.models.forEach((group, index) => {
    progress(`${index + 1} of ${grouping.models.length}: ${group.name}`);
    const wanted = group.files.filter(({ method }) => !truthOnly || method === undefined);
    const inputs = readInputs(wanted, byPath, diagnostics);
    const model = engine.Model.read(group.name, inputs);
    try {
      visit(model, inputs);
    } finally {
      model.free();
    }
  });
  return diagnostics;
}
