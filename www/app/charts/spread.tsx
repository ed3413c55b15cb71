// How measures are spread over models: the paper's box plots.

import type { JSX } from "preact";
import type { Signal } from "@preact/signals";
import type { Distribution, Measure } from "../engine/contract";
import { isShare, MEASURE } from "../measures/measures";
import { means } from "../scores/means";
import { scoredRows } from "../state/models";
import { protocol } from "../state/settings";
import { count, words } from "../ui/columns";
import * as format from "../ui/format";
import { Table, type Column } from "../ui/table";
import { Chart } from "./figure";
import { decades, drawn, leading, legend, Plot, tick, type Frame } from "./plot";
import { goTo, isSelected, methodColour } from "./scope";

interface Box {
  readonly measure: Measure;
  readonly method: string;
  readonly over: Distribution;
}

interface Value {
  readonly measure: Measure;
  readonly method: string;
  readonly model: string;
  readonly value: number;
}

const figure = (head: string, label: string, of: (over: Distribution) => number): Column<Box> => ({
  id: label,
  head,
  label,
  numeric: true,
  cell: ({ measure, over }) => format.measure(measure, of(over)),
  sortBy: ({ over }) => of(over),
  title: ({ over }) => String(of(over)),
});

const COLUMNS: readonly Column<Box>[] = [
  words("measure", "Measure", ({ measure }) => measure),
  words("method", "Method", ({ method }) => method),
  count("count", "Models", ({ over }) => over.count),
  figure("Least", "least", ({ min }) => min),
  figure("Lower quartile", "lower quartile", ({ lowerQuartile }) => lowerQuartile),
  figure("Median", "median", ({ median }) => median),
  figure("Upper quartile", "upper quartile", ({ upperQuartile }) => upperQuartile),
  figure("Largest", "largest", ({ max }) => max),
  figure("Mean", "mean", ({ mean }) => mean),
];

interface Props {
  readonly name: string;
  readonly title: string;
  readonly measures: readonly Measure[];
  /** The choice of a logarithmic axis, for measures that are no shares. */
  readonly logarithmic?: Signal<boolean>;
}

export function SpreadChart({ name, title, measures, logarithmic }: Props): JSX.Element | null {
  const known = means.value?.protocol === protocol.value ? means.value : undefined;
  const boxes = measures.flatMap((measure) =>
    (known?.methods ?? []).flatMap(({ method, over }) => (over[measure] ? [{ measure, method, over: over[measure] }] : [])),
  );
  if (boxes.length === 0) return null;
  const values = measures.flatMap((measure) =>
    scoredRows.value.flatMap(({ entry, reports }): Value[] => {
      const value = reports[protocol.value].mean[measure];
      return value === null ? [] : [{ measure, method: reports.method, model: entry.id, value }];
    }),
  );
  const log = logarithmic?.value === true && values.some(({ value }) => value > 0);
  const better = measures.some((measure) => MEASURE[measure].better === "lower") ? "Lower" : "Higher";
  return (
    <Chart
      name={name}
      title={title}
      description={`${better} is better. Box: quartiles and median; whiskers: least and largest; diamond: mean; dots: models.${log && values.some(({ value }) => value <= 0) ? " On a logarithmic axis 0 lies on the lower edge." : ""}`}
      draw={(frame) => draw(frame, measures, boxes, values, log)}
      {...(logarithmic && { logarithmic })}
      table={() => (
        <Table caption={title} columns={COLUMNS} rows={boxes} keyOf={({ measure, method }) => `${measure} ${method}`} />
      )}
    />
  );
}

function draw(
  frame: Frame,
  measures: readonly Measure[],
  boxes: readonly Box[],
  values: readonly Value[],
  log: boolean,
): SVGSVGElement {
  // A logarithm has no place for 0: it is drawn on the lower edge, at the power of ten below all else.
  const least = values.reduce((found, { value }) => (value > 0 && value < found ? value : found), Infinity);
  const edge = log ? 10 ** Math.floor(Math.log10(least)) : -Infinity;
  const largest = values.reduce((found, { value }) => Math.max(found, value), edge);
  const top = largest > edge ? largest : 10 * edge;
  const up = (value: number) => Math.max(value, edge);
  const scale = log
    ? { type: "log", domain: [edge, top] } as const
    : { zero: true, nice: true, ...(measures.every(isShare) ? { domain: [0, 1] } : {}) };
  const methods = [...new Set(boxes.map(({ method }) => method))];
  const marginLeft = 52;
  const keys = legend(methods.map((text) => ({ text, colour: methodColour(text) })), frame, marginLeft);
  const column = { fx: "measure", x: "method" } as const;
  const wide = { insetLeft: 2, insetRight: 2 };
  const current = values.filter(isSelected);
  const place = { ...column, y: ({ value }: Value) => up(value), r: 2.5 } as const;
  return drawn(frame, {
    height: 250 + keys.height,
    marginLeft,
    marginTop: keys.height + 4,
    marginBottom: 24,
    fx: { domain: measures, label: null, padding: 0.12, axis: null },
    x: { domain: methods, axis: null, padding: 0.15 },
    y: { label: null, ...scale },
    marks: [
      Plot.gridY({ stroke: frame.line, strokeOpacity: 1 }),
      Plot.axisFx({ anchor: "bottom", label: null, fontSize: 11 }),
      Plot.axisY({ label: null, ...(log ? { tickFormat: decades(edge, top) } : measures.every(isShare) ? {} : { tickFormat: tick }) }),
      Plot.ruleX(boxes, { ...column, y1: ({ over }: Box) => up(over.min), y2: ({ over }: Box) => up(over.max), stroke: frame.ink }),
      Plot.barY(boxes, {
        ...column,
        ...wide,
        y1: ({ over }: Box) => up(over.lowerQuartile),
        y2: ({ over }: Box) => up(over.upperQuartile),
        fill: ({ method }: Box) => methodColour(method),
        stroke: frame.ink,
        className: "boxes",
      }),
      Plot.tickY(boxes, { ...column, ...wide, y: ({ over }: Box) => up(over.median), stroke: frame.ink, strokeWidth: 2.5 }),
      Plot.dot(boxes, { ...column, y: ({ over }: Box) => up(over.mean), symbol: "diamond", r: 4, fill: frame.surface, stroke: frame.ink }),
      Plot.dot(values, {
        ...place,
        fill: frame.surface,
        stroke: frame.ink,
        className: "models-dots",
        title: ({ model, method, measure, value }: Value) => `${model} by ${method}: ${measure} ${format.measure(measure, value)}`,
        ...leading(values, ({ model, method }) => goTo(model, method)),
      }),
      // Lets clicks through to the dot it rings.
      Plot.dot(current, { ...place, r: 5, stroke: frame.accent, strokeWidth: 2, pointerEvents: "none" }),
      ...keys.marks,
    ],
  });
}
