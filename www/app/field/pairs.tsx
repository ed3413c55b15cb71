// Two methods at a time, model by model: wins, ties, losses, and whether that is more than chance.

import type { JSX } from "preact";
import type { FieldSums } from "../../worker/protocol";
import type { FigureInfo } from "../engine/contract";
import * as format from "../ui/format";
import { words } from "../ui/columns";
import { Table, type Column } from "../ui/table";

type Row = FieldSums["comparisons"][number];

export function PairsTable({ figures, comparisons }: { figures: readonly FigureInfo[]; comparisons: readonly Row[] }): JSX.Element | null {
  const rows = comparisons.filter(({ figure, better, even, worse }) => better + even + worse > 1 && figures.some(({ key }) => key === figure));
  if (rows.length === 0) return null;
  return (
    <>
      <Table
        className="field"
        caption="Method against method, model by model"
        columns={COLUMNS}
        rows={rows}
        keyOf={({ figure, method, against }) => `${figure} ${method} ${against}`}
      />
      <p class="note">p is that of Wilcoxon’s signed-rank test, two-sided: below 0.05 chance alone is unlikely.</p>
    </>
  );
}

const COLUMNS: readonly Column<Row>[] = [
  words("pair", "Methods", ({ method, against }) => `${method} − ${against}`),
  words("figure", "Figure", ({ title }) => title),
  {
    id: "mean",
    head: "Mean difference",
    label: "mean difference",
    numeric: true,
    cell: ({ mean }) => signed(mean?.by),
    sortBy: ({ mean }) => mean?.by,
  },
  {
    id: "wins",
    head: "Won, even, lost",
    label: "models won",
    numeric: true,
    cell: ({ better, even, worse }) => `${better}, ${even}, ${worse}`,
    sortBy: ({ better }) => better,
  },
  {
    id: "p",
    head: "p",
    label: "probability of chance",
    numeric: true,
    cell: ({ test }) => format.probability(test?.probability),
    sortBy: ({ test }) => test?.probability,
    title: ({ test }) => (test ? `${test.pairs} differences, ${test.exact ? "counted exactly" : "normal distribution"}` : undefined),
  },
];

function signed(value: number | undefined): string {
  if (value === undefined) return format.MISSING;
  return `${value > 0 ? "+" : value < 0 ? "−" : ""}${Math.abs(value).toFixed(4)}`;
}
