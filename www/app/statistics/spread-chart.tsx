// How a figure is spread over the models of each set.

import type { JSX } from "preact";
import { Chart } from "../charts/figure";
import { drawn, Plot, type Frame } from "../charts/plot";
import type { DatasetStatistics, Spread } from "../engine/contract";
import { segmentColour } from "../view/palette";
import { Table, type Column } from "../ui/table";
import type { CountedModel, CountedSet } from "./state";

export interface Figure {
  readonly id: string;
  readonly title: string;
  readonly axis: string;
  readonly of: (model: CountedModel) => number | undefined;
  readonly spread: (set: DatasetStatistics) => Spread | null;
  readonly write: (value: number) => string;
  /** At ticks, where there is less room. */
  readonly tick: string | ((value: number) => string);
}

interface Row {
  readonly set: string;
  readonly spread: Spread;
}

interface Value {
  readonly set: string;
  readonly value: number;
}

interface Props {
  readonly figure: Figure;
  readonly models: readonly CountedModel[];
  readonly sets: readonly CountedSet[];
}

export function SpreadChart({ figure, models, sets }: Props): JSX.Element | null {
  const values = models.flatMap((model): Value[] => {
    const value = figure.of(model);
    return value === undefined ? [] : [{ set: model.set, value }];
  });
  const rows = sets.flatMap(({ name, statistics }): Row[] => {
    const spread = figure.spread(statistics);
    return spread ? [{ set: name, spread }] : [];
  });
  // One model is spread over nothing, and so is nothing.
  if (values.length < 2 || values.every(({ value }) => value === 0)) return null;
  return (
    <Chart
      name={figure.id}
      title={figure.title}
      description={`${rows.length > 1 ? "Share of the set's models" : "Number of models"}; the line is at the median: ${rows.map(({ set, spread }) => `${rows.length > 1 ? `${set} ` : ""}${figure.write(spread.median)}`).join(", ")}.`}
      draw={(frame) => draw(frame, figure, values, rows)}
      table={() => <Table caption={figure.title} columns={columnsOf(figure)} rows={rows} keyOf={({ set }) => set} />}
    />
  );
}

function columnsOf({ write }: Figure): Column<Row>[] {
  const part = (id: keyof Spread, head: string): Column<Row> => ({
    id,
    head,
    label: head.toLowerCase(),
    numeric: true,
    cell: ({ spread }) => write(spread[id]),
    sortBy: ({ spread }) => spread[id],
  });
  return [{ id: "set", head: "Set", label: "set", cell: ({ set }) => set }, part("min", "Least"), part("median", "Median"), part("max", "Most")];
}

function draw(frame: Frame, { axis, tick }: Figure, values: readonly Value[], rows: readonly Row[]): SVGSVGElement {
  const sets = rows.map(({ set }) => set);
  const several = sets.length > 1;
  // Sets of different sizes are compared by shares.
  const y = several ? "proportion-facet" : "count";
  const ticks = several ? 4 : WHOLE;
  const bars = {
    x: "value",
    fy: "set",
    thresholds: thresholds(values),
    fill: ({ set }: Value) => segmentColour(sets.indexOf(set)),
    stroke: frame.soft,
    strokeWidth: 0.75,
  };
  return drawn(frame, {
    height: 60 + (several ? 150 : 190) * sets.length,
    marginLeft: 40,
    marginTop: several ? 22 : 10,
    marginBottom: 38,
    marginRight: 16,
    fy: { domain: sets, label: null, axis: null, padding: 0.2 },
    x: { label: axis, nice: true, zero: true },
    y: { label: null, nice: true },
    marks: [
      Plot.gridY({ stroke: frame.line, strokeOpacity: 1, ticks }),
      Plot.axisX({ label: axis, ticks: Math.max(2, Math.floor(frame.width / 90)), tickFormat: tick }),
      Plot.axisY({ label: null, ticks, tickFormat: several ? "~%" : "d" }),
      Plot.rectY(values, Plot.binX({ y }, bars)),
      Plot.ruleX(rows, { x: ({ spread }: Row) => spread.median, fy: "set", stroke: frame.ink, strokeWidth: 2, strokeDasharray: "5 3" }),
      ...(several ? [Plot.text(rows, { text: "set", fy: "set", frameAnchor: "top-right", dy: -12, fill: frame.ink, fontWeight: 600 })] : []),
    ],
  });
}

const BINS = 24;

/** From nothing to just above the largest value, which a bin that ends at it would leave out. */
function thresholds(values: readonly Value[]): number[] {
  const most = values.reduce((largest, { value }) => Math.max(largest, value), 0) || 1;
  return Array.from({ length: BINS + 1 }, (_, bin) => (most * (1 + 1e-9) * bin) / BINS);
}

/** Ticks for counts: half a model is no figure. */
const WHOLE = {
  floor: Math.floor,
  offset: (value: number, step = 1) => value + step,
  range(start: number, stop: number) {
    const step = niceStep((stop - start) / 4);
    const first = Math.ceil(start / step);
    return Array.from({ length: Math.floor(stop / step) - first + 1 }, (_, at) => (first + at) * step);
  },
};

/** The least of 1, 2, 5, 10, 20 … that is not below a width. */
function niceStep(width: number): number {
  const decade = 10 ** Math.max(0, Math.floor(Math.log10(width)));
  return [1, 2, 5, 10].map((factor) => factor * decade).find((step) => step >= width) ?? decade;
}
