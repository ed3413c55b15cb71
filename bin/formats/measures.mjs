// The measures in the order of the paper's tables.

export const MEASURES = ["DSC", "PPV", "TPR", "TNR", "NPV", "ACC", "MFE", "dHaus", "d1"];

/** Mean over the reports that have the measure, or null where none has. */
export function meanOf(reports, measure) {
  const values = reports.map(({ mean }) => mean[measure]).filter((value) => value !== null);
  return values.length === 0 ? null : values.reduce((sum, value) => sum + value, 0) / values.length;
}

/** The methods in the order in which they first appear. */
export function methodsOf(reports) {
  return [...new Set(reports.map(({ method }) => method))];
}
