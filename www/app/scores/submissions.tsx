// One row per submission, the means at the foot.

import type { JSX } from "preact";
import { signal } from "@preact/signals";
import { measureColumn } from "../measures/column";
import { MEASURES } from "../measures/measures";
import { isFitted, scoredRows, type ScoredRow } from "../state/models";
import { selectedMethod, selectedModel, selectModel } from "../state/selection";
import { protocol } from "../state/settings";
import { count, words } from "../ui/columns";
import * as format from "../ui/format";
import { Table, type Column, type Sorting } from "../ui/table";
import { means } from "./means";

const sorting = signal<Sorting | undefined>(undefined);

function report({ reports }: ScoredRow) {
  return reports[protocol.value];
}

const COLUMNS: readonly Column<ScoredRow>[] = [
  words("model", "Model", ({ entry }) => entry.id),
  {
    ...words<ScoredRow>("method", "Method", ({ reports }) => reports.method),
    cell: ({ entry, reports }) =>
      isFitted(entry, reports.method) ? (
        <>
          {reports.method} <abbr title="Its surfaces were fitted here to the segments that were given">†</abbr>
        </>
      ) : (
        reports.method
      ),
  },
  count("points", "Points", (row) => report(row).points),
  count("truth", "True", (row) => report(row).truth, { label: "true primitives" }),
  count("predicted", "Pred.", (row) => report(row).predicted, { label: "predicted primitives" }),
  ...MEASURES.map((measure) => measureColumn<ScoredRow>(measure, (row) => report(row).mean[measure])),
  {
    ...count<ScoredRow>("types", "Type err.", (row) => report(row).type_errors, { label: "type errors" }),
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
