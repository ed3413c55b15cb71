// One row per submission, the means at the foot.

import type { JSX } from "preact";
import { signal } from "@preact/signals";
import { ExplainButton } from "../measures/explain";
import { isShare, MEASURES } from "../measures/measures";
import { scoredRows, type ScoredRow } from "../state/models";
import { selectedMethod, selectedModel, selectModel } from "../state/selection";
import { protocol } from "../state/settings";
import * as format from "../ui/format";
import { Table, type Column, type Sorting } from "../ui/table";
import { means } from "./means";

const sorting = signal<Sorting | undefined>(undefined);

function report({ reports }: ScoredRow) {
  return reports[protocol.value];
}

const COLUMNS: readonly Column<ScoredRow>[] = [
  { id: "model", head: "Model", label: "model", cell: ({ entry }) => entry.id, sortBy: ({ entry }) => entry.id },
  {
    id: "method",
    head: "Method",
    label: "method",
    cell: ({ reports }) => reports.method,
    sortBy: ({ reports }) => reports.method,
  },
  {
    id: "points",
    head: "Points",
    label: "points",
    numeric: true,
    cell: (row) => format.integer(report(row).points),
    sortBy: (row) => report(row).points,
  },
  {
    id: "truth",
    head: "True",
    label: "true primitives",
    numeric: true,
    cell: (row) => report(row).truth,
    sortBy: (row) => report(row).truth,
  },
  {
    id: "predicted",
    head: "Pred.",
    label: "predicted primitives",
    numeric: true,
    cell: (row) => report(row).predicted,
    sortBy: (row) => report(row).predicted,
  },
  ...MEASURES.map(
    (measure): Column<ScoredRow> => ({
      id: measure,
      head: measure,
      aside: <ExplainButton measure={measure} />,
      label: measure,
      numeric: true,
      cell: (row) => format.measure(measure, report(row).mean[measure]),
      sortBy: (row) => report(row).mean[measure],
      title: (row) => report(row).mean[measure]?.toString(),
      ...(isShare(measure) ? { share: (row: ScoredRow) => report(row).mean[measure] } : {}),
    }),
  ),
  {
    id: "types",
    head: "Type err.",
    label: "type errors",
    numeric: true,
    cell: (row) => report(row).type_errors,
    sortBy: (row) => report(row).type_errors,
    title: () => "Predicted primitives whose type differs from that of their most overlapping true one",
  },
];

export function SubmissionTable({ caption }: { caption: string }): JSX.Element {
  return (
    <Table
      className="scores"
      caption={caption}
      columns={COLUMNS}
      rows={scoredRows.value}
      keyOf={({ key }) => key}
      sorting={sorting}
      isSelected={({ entry, reports }) => entry.id === selectedModel.value && reports.method === selectedMethod.value}
      onSelect={({ entry, reports }) => selectModel(entry.id, reports.method)}
      foot={<MeanRows />}
    />
  );
}

function MeanRows(): JSX.Element | null {
  if (!means.value) return null;
  return (
    <>
      {means.value.methods.map(({ method, models, over }) => (
        <tr key={method}>
          <th scope="row">Mean</th>
          <td>{method}</td>
          <td colSpan={3}>{format.plural(models, "model")}</td>
          {MEASURES.map((measure) => (
            <td key={measure} class="numeric" title={titleOf(over[measure], models)}>
              {format.measure(measure, over[measure]?.mean)}
            </td>
          ))}
          <td />
        </tr>
      ))}
    </>
  );
}

/** Says so where some models have no value. */
export function titleOf(spread: { mean: number; count: number } | undefined, models: number): string | undefined {
  if (!spread) return undefined;
  return spread.count < models ? `${spread.mean} over the ${spread.count} of ${models} models that have it` : String(spread.mean);
}
