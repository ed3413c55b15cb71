// The primitives of the selected model as a table, or by type as a tree. In the table there is one row per
// primitive: the true ones with their match, then the predictions that match nothing.

import type { JSX } from "preact";
import { computed, signal } from "@preact/signals";
import type { PredictionReport, TruthReport } from "../engine/contract";
import { measureColumn } from "../measures/column";
import { ACCURACY_MEASURES, MEASURES } from "../measures/measures";
import { predictionColours } from "../stage/colouring";
import { reports } from "../stage/reports";
import {
  hoveredPrimitive,
  selectedModel,
  selectedPrimitive,
  selectedReports,
  togglePrimitive,
  type PrimitiveRef,
} from "../state/selection";
import { placeOfMatch } from "../state/matches";
import { protocol, remembered } from "../state/settings";
import { count, words } from "../ui/columns";
import { Swatch } from "../ui/swatch";
import { Table, type Column, type Sorting } from "../ui/table";
import { segmentColour, UNSEGMENTED } from "../view/palette";
import { FoundPrimitives } from "./found";
import { PrimitiveTree } from "./tree";

const AS = [
  { id: "table", title: "Table" },
  { id: "tree", title: "By type" },
] as const;

const shownAs = remembered("primitives", "table", ["table", "tree"] as const);

interface TruthRow {
  readonly index: number;
  readonly report: TruthReport;
  /** Place of the match among the predictions. */
  readonly match: number | undefined;
  readonly prediction: PredictionReport | undefined;
}

interface SpuriousRow {
  readonly index: number;
  readonly report: PredictionReport;
  readonly colour: string;
}

const rows = computed<readonly TruthRow[]>(() => {
  const report = selectedReports.value?.[protocol.value];
  if (!report) return [];
  return report.primitives.map((truth, index) => {
    const match = placeOfMatch(report, index);
    return { index, report: truth, match, prediction: match === undefined ? undefined : report.predictions[match] };
  });
});

const spurious = computed<readonly SpuriousRow[]>(() => {
  const report = selectedReports.value?.[protocol.value];
  if (!report) return [];
  const numbers = new Set(report.hidden.spurious);
  const colours = predictionColours(report, report.predictions.length);
  return report.predictions.flatMap((prediction, index) =>
    numbers.has(prediction.prediction) ? [{ index, report: prediction, colour: colours[index] ?? UNSEGMENTED }] : [],
  );
});

const sorting = signal<Sorting | undefined>(undefined);
const spuriousSorting = signal<Sorting | undefined>(undefined);

const COLUMNS: readonly Column<TruthRow>[] = [
  {
    id: "truth",
    head: "True",
    label: "true primitive",
    cell: ({ index, report }) => (
      <>
        <Swatch colour={segmentColour(index)} />
        {report.truth}
      </>
    ),
    sortBy: ({ report }) => report.truth,
  },
  words("type", "Type", ({ report }) => report.type, { missing: "other" }),
  count("size", "Points", ({ report }) => report.size),
  {
    id: "match",
    head: "Match",
    label: "match",
    cell: ({ prediction }) => prediction?.prediction ?? <span class="missing">missed</span>,
    sortBy: ({ prediction }) => prediction?.prediction,
  },
  {
    id: "match-type",
    head: "Its type",
    label: "type of the match",
    cell: ({ prediction, report }) =>
      prediction && (
        <span class={prediction.type && report.type && prediction.type !== report.type ? "wrong" : undefined}>
          {prediction.type ?? "other"}
        </span>
      ),
    sortBy: ({ prediction }) => prediction?.type,
  },
  count("match-size", "Points", ({ prediction }) => prediction?.size, { label: "points of the match" }),
  ...MEASURES.map((measure) => measureColumn<TruthRow>(measure, ({ report }) => report[measure])),
];

const SPURIOUS_COLUMNS: readonly Column<SpuriousRow>[] = [
  {
    id: "prediction",
    head: "Prediction",
    label: "prediction",
    cell: ({ report, colour }) => (
      <>
        <Swatch colour={colour} />
        {report.prediction}
      </>
    ),
    sortBy: ({ report }) => report.prediction,
  },
  words("type", "Type", ({ report }) => report.type, { missing: "other" }),
  count("size", "Points", ({ report }) => report.size),
  count("overlaps", "Mostly overlaps true", ({ report }) => report.match, {
    label: "most overlapping true primitive",
    missing: "none",
  }),
  ...ACCURACY_MEASURES.map((measure) => measureColumn<SpuriousRow>(measure, ({ report }) => report[measure])),
];

function isRef(ref: PrimitiveRef | undefined, side: PrimitiveRef["side"], index: number | undefined): boolean {
  return ref !== undefined && ref.side === side && ref.index === index;
}

/** A row stands for its true primitive and for that one's matches. */
function concerns(ref: PrimitiveRef | undefined, row: TruthRow): boolean {
  const { rival } = reports.value;
  return (
    isRef(ref, "truth", row.index) ||
    isRef(ref, "prediction", row.match) ||
    (rival !== undefined && isRef(ref, "rival", placeOfMatch(rival, row.index)))
  );
}

export default function PrimitivesPanel(): JSX.Element {
  const choice = (
    <fieldset class="switch primitives-as">
      <legend class="visually-hidden">Primitives as</legend>
      {AS.map(({ id, title }) => (
        <label key={id}>
          <input type="radio" name="primitives-as" checked={shownAs.value === id} onChange={() => (shownAs.value = id)} />
          <span>{title}</span>
        </label>
      ))}
    </fieldset>
  );
  if (shownAs.value === "tree") return <PrimitiveTree>{choice}</PrimitiveTree>;
  return (
    <>
      {choice}
      <PrimitiveTable />
    </>
  );
}

function PrimitiveTable(): JSX.Element {
  const report = selectedReports.value?.[protocol.value];
  if (!report) return <FoundPrimitives />;
  return (
    <>
      <Table
        className="primitives"
        caption={`Primitives of ${selectedModel.value} and their matches by ${report.method}`}
        columns={COLUMNS}
        rows={rows.value}
        keyOf={({ index }) => String(index)}
        sorting={sorting}
        isSelected={(row) => concerns(selectedPrimitive.value, row)}
        isHovered={(row) => concerns(hoveredPrimitive.value, row)}
        onSelect={({ index }) => togglePrimitive({ side: "truth", index })}
        onHover={(row) => (hoveredPrimitive.value = row && { side: "truth", index: row.index })}
      />
      {spurious.value.length > 0 && (
        <Table
          className="primitives"
          caption="Predictions that match no true primitive: the classification measures do not see them"
          columns={SPURIOUS_COLUMNS}
          rows={spurious.value}
          keyOf={({ index }) => String(index)}
          sorting={spuriousSorting}
          isSelected={({ index }) => isRef(selectedPrimitive.value, "prediction", index)}
          isHovered={({ index }) => isRef(hoveredPrimitive.value, "prediction", index)}
          onSelect={({ index }) => togglePrimitive({ side: "prediction", index })}
          onHover={(row) => (hoveredPrimitive.value = row && { side: "prediction", index: row.index })}
        />
      )}
    </>
  );
}
