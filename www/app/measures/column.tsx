// A measure as a column: explained at its head, rounded in its cells, whole where the cursor rests.

import type { Measure } from "../engine/contract";
import * as format from "../ui/format";
import type { Column } from "../ui/table";
import { ExplainButton } from "./explain";
import { isShare } from "./measures";

export function measureColumn<Row>(measure: Measure, of: (row: Row) => number | null | undefined): Column<Row> {
  return {
    id: measure,
    head: measure,
    aside: <ExplainButton measure={measure} />,
    label: measure,
    numeric: true,
    cell: (row) => format.measure(measure, of(row)),
    sortBy: of,
    title: (row) => of(row)?.toString(),
    ...(isShare(measure) ? { share: of } : {}),
  };
}
