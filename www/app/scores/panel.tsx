// One row per model and method with every measure.

import type { JSX } from "preact";
import { signal } from "@preact/signals";
import type { Measure } from "../engine/contract";
import { ExplainButton } from "../measures/explain";
import { CLASSIFICATION_MEASURES, MEASURES } from "../measures/measures";
import { models, scoredRows, type ScoredRow } from "../state/models";
import { selectedMethod, selectedModel, selectModel } from "../state/selection";
import { protocol } from "../state/settings";
import * as format from "../ui/format";
import { Table, type Column, type Sorting } from "../ui/table";

const sorting = signal<Sorting | undefined>(undefined);

function report({ reports }: ScoredRow) {
  return reports[protocol.value];
}

const isShare = (measure: Measure) => (CLASSIFICATION_MEASURES as readonly Measure[]).includes(measure);

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

export default function ScoresPanel(): JSX.Element {
  const rows = scoredRows.value;
  if (rows.length === 0) return <NothingScored />;
  const published = protocol.value === "published";
  return (
    <Table
      className="scores"
      caption={
        <>
          Means over primitives, {published ? "as the published tables were made" : "by definition"}.{" "}
          {format.plural(rows.length, "row")}.
        </>
      }
      columns={COLUMNS}
      rows={rows}
      keyOf={({ key }) => key}
      sorting={sorting}
      isSelected={({ entry, reports }) => entry.id === selectedModel.value && reports.method === selectedMethod.value}
      onSelect={({ entry, reports }) => selectModel(entry.id, reports.method)}
    />
  );
}

function NothingScored(): JSX.Element {
  const waiting = models.value.some(({ status }) => status.kind === "waiting");
  if (waiting) return <p class="empty">Scoring…</p>;
  if (models.value.length === 0) return <p class="empty">No models yet.</p>;
  return (
    <p class="empty">
      Nothing to score: a model needs its ground truth and at least one submission. Add the missing files, or correct
      what they are under Files.
    </p>
  );
}
