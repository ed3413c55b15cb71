// Methods against figures: the mean over a set's models with its interval, shaded from the worst to the best.

import type { ComponentChildren, JSX } from "preact";
import type { Signal } from "@preact/signals";
import { titleOfKind } from "../../shared/results/kinds.mjs";
import type { FigureSpread, Measure } from "../engine/contract";
import { ExplainButton } from "../measures/explain";
import { MEASURES } from "../measures/measures";
import * as format from "../ui/format";
import { Table, type Column, type Sorting } from "../ui/table";
import { heatOf, inOrder, isBest, meanOf, type Figure } from "./columns";
import { timeOf } from "./time";
import { summaryOf, type Row } from "./table-data";

interface Props {
  readonly caption: ComponentChildren;
  readonly rows: readonly Row[];
  /** Under each head a figure, on a set. */
  readonly columns: readonly { readonly figure: Figure; readonly set: string; readonly head: string }[];
  /** Whose times are told. */
  readonly set: string;
  readonly sorting: Signal<Sorting | undefined>;
  readonly onOpen: (row: Row) => void;
}

export function StandingTable({ caption, rows, columns, set, sorting, onOpen }: Props): JSX.Element {
  const first = columns[0];
  const ordered = first
    ? [...rows].sort((one, other) => inOrder(first.figure, meanIn(one, first)?.mean, meanIn(other, first)?.mean) || one.method.name.localeCompare(other.method.name))
    : rows;
  return (
    <Table
      className="field standing"
      caption={<span class="results-caption">{caption}</span>}
      columns={[METHOD, timeColumn(set, rows), ...columns.map((column) => figureColumn(column, rows))]}
      rows={ordered}
      keyOf={({ id }) => id}
      sorting={sorting}
      onSelect={onOpen}
    />
  );
}

function meanIn(row: Row, { figure, set }: { figure: Figure; set: string }): FigureSpread | undefined {
  return meanOf(figure, summaryOf(row, set));
}

const METHOD: Column<Row> = {
  id: "method",
  head: "Method",
  label: "method",
  cell: ({ method }) => (
    <span>
      {method.name}
      <small class="aside">
        {titleOfKind(method.kind)}, {method.year}
      </small>
    </span>
  ),
  sortBy: ({ method }) => method.name,
};

function figureColumn(column: Props["columns"][number], rows: readonly Row[]): Column<Row> {
  const { figure, set, head } = column;
  const means = rows.map((row) => meanIn(row, column)?.mean);
  const heat = heatOf(figure, means);
  return {
    id: `${figure.key} ${set}`,
    head,
    aside: isMeasure(figure.key) && head === figure.title ? <ExplainButton measure={figure.key} /> : undefined,
    label: head,
    numeric: true,
    cell: (row) => {
      const spread = meanIn(row, column);
      const best = isBest(figure, spread?.mean, means);
      return (
        <Shaded heat={best ? 1 : heat(spread?.mean)}>
          {best ? <strong>{figure.write(spread?.mean)}</strong> : figure.write(spread?.mean)}
          {fittedHere(row, set, figure) && <abbr title="The answers came without surfaces; types and distances are of those fitted here">†</abbr>}
          <small class="aside">{intervalOf(figure, spread)}</small>
        </Shaded>
      );
    },
    sortBy: (row) => meanIn(row, column)?.mean,
    title: (row) => titleOf(figure, meanIn(row, column)),
  };
}

function isMeasure(key: string): key is Measure {
  return (MEASURES as readonly string[]).includes(key);
}

/** Behind a figure that is computed from surfaces: whether the engine had to fit those. */
function fittedHere(row: Row, set: string, { better }: Figure): boolean {
  return better === "lower" && (summaryOf(row, set)?.surfacesFitted ?? 0) > 0;
}

function intervalOf({ write }: Figure, spread: FigureSpread | undefined): string {
  return spread?.interval ? `${write(spread.interval[0])} – ${write(spread.interval[1])}` : "";
}

function titleOf({ write }: Figure, spread: FigureSpread | undefined): string | undefined {
  if (!spread) return undefined;
  return `${spread.mean} over ${format.plural(spread.count, "model")}; median ${write(spread.median)}, quartiles ${write(spread.lowerQuartile)} and ${write(spread.upperQuartile)}`;
}

function timeColumn(set: string, rows: readonly Row[]): Column<Row> {
  const log = (row: Row) => {
    const seconds = timeOf(row, set)?.seconds;
    return seconds === undefined || seconds <= 0 ? undefined : Math.log(seconds);
  };
  const heat = heatOf({ better: "lower" }, rows.map(log));
  return {
    id: "seconds",
    head: "Seconds a cloud",
    label: "seconds a cloud",
    numeric: true,
    cell: (row) => {
      const time = timeOf(row, set);
      return (
        <Shaded heat={heat(log(row))}>
          {time ? time.text : format.MISSING}
          <small class="aside">{time && `${time.what}, ${time.platform}`}</small>
        </Shaded>
      );
    },
    sortBy: (row) => timeOf(row, set)?.seconds,
    title: (row) => timeOf(row, set)?.machine,
  };
}

/** Shading says again what the figure says, and alone says nothing. */
function Shaded({ heat, children }: { heat: number; children: ComponentChildren }): JSX.Element {
  return (
    <span class="shaded" style={{ "--heat": heat.toFixed(3) }}>
      {children}
    </span>
  );
}
