// The comparison as it is saved: differences, the figures they are of, and the sums.

import type { Sheet, Sheets } from "../../shared/formats/sheet.mjs";
import type { Comparison, Difference, Measure } from "../engine/contract";
import { MEASURE, MEASURES } from "../measures/measures";

/** A model with the figures of both sides. */
export interface Compared {
  readonly model: string;
  readonly test: string;
  readonly own: (measure: Measure) => number | null;
  readonly theirs: (measure: Measure) => number | null;
  readonly difference: (measure: Measure) => Difference | null | undefined;
}

interface Sides {
  readonly own: string;
  readonly theirs: string;
}

const columns = MEASURES.map((measure) => ({ title: measure, decimals: MEASURE[measure].decimals }));
const heads = ["model", "test model"];

/** The sheets of a comparison; `rows` in the order in which they are shown. */
export function sheetsOf({ own, theirs }: Sides, rows: readonly Compared[], by: ReadonlyMap<Measure, Comparison>, note: string): Sheets {
  const of = (caption: string, value: (row: Compared, measure: Measure) => number | null): Sheet => ({
    ...{ caption, heads, columns },
    rows: rows.map((row) => ({ labels: [row.model, row.test], values: MEASURES.map((measure) => value(row, measure)) })),
  });
  const sum = (label: string, value: (comparison: Comparison) => number | null | undefined) => ({
    labels: [label],
    values: MEASURES.map((measure) => {
      const comparison = by.get(measure);
      return (comparison && value(comparison)) ?? null;
    }),
  });
  const differences = `${own} minus ${theirs}`;
  return {
    sheets: [
      of(differences, (row, measure) => row.difference(measure)?.by ?? null),
      of(own, (row, measure) => row.own(measure)),
      of(theirs, (row, measure) => row.theirs(measure)),
      {
        ...{ caption: `Sums of ${differences}`, heads: [""], columns },
        rows: [
          sum("mean difference", ({ mean }) => mean?.by),
          sum(`mean of ${own}`, (comparison) => comparison.own),
          sum(`mean of ${theirs}`, (comparison) => comparison.theirs),
        ],
      },
      {
        ...{ caption: `Models won, lost and even by ${own}`, heads: [""], columns: MEASURES.map((title) => ({ title, decimals: 0 })) },
        rows: [sum("won", ({ better }) => better), sum("lost", ({ worse }) => worse), sum("even", ({ even }) => even)],
      },
      {
        ...{ caption: "Wilcoxon's signed-rank test", heads: [""], columns: MEASURES.map((title) => ({ title, decimals: 4 })) },
        rows: [sum("p", ({ test }) => test?.probability)],
      },
    ],
    notes: [note],
  };
}
