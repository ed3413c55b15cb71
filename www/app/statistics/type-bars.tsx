// How many primitives of a set are of each type: the paper's bar charts.

import type { JSX } from "preact";
import { Chart } from "../charts/figure";
import { drawn, Plot, type Frame } from "../charts/plot";
import { typeColour, TYPES } from "../charts/surface-types";
import type { DatasetStatistics } from "../engine/contract";
import { count } from "../ui/columns";
import * as format from "../ui/format";
import { Table, type Column } from "../ui/table";
import type { CountedSet } from "./state";

interface Bar {
  readonly type: string;
  readonly count: number;
  readonly share: number;
}

const COLUMNS: readonly Column<Bar>[] = [
  { id: "type", head: "Type", label: "type", cell: ({ type }) => type },
  count("count", "Primitives", (bar) => bar.count),
  {
    id: "share",
    head: "Share",
    label: "share of all",
    numeric: true,
    cell: ({ share }) => format.share(share),
    sortBy: ({ share }) => share,
    share: ({ share }) => share,
  },
];

function barsOf({ types, typeShares }: DatasetStatistics): Bar[] {
  const bars = TYPES.map((name) => {
    const type = name as keyof typeof types;
    return { type: name, count: types[type], share: typeShares?.[type] ?? 0 };
  });
  // The paper's charts have the five types; what is none of them is shown where there is any.
  return bars.filter(({ type, count }) => type !== "Other" || count > 0);
}

export function TypeBars({ set: { name, statistics }, only }: { set: CountedSet; only: boolean }): JSX.Element {
  const bars = barsOf(statistics);
  const title = only ? "Surface types" : `Surface types, ${name}`;
  return (
    <Chart
      name={`surface-types-${name}`}
      title={title}
      description={`${format.plural(statistics.primitives, "true primitive")} of ${format.plural(statistics.models, "model")}.`}
      draw={(frame) => draw(frame, bars)}
      table={() => <Table caption={title} columns={COLUMNS} rows={bars} keyOf={({ type }) => type} />}
    />
  );
}

function draw(frame: Frame, bars: readonly Bar[]): SVGSVGElement {
  return drawn(frame, {
    height: 260,
    marginLeft: 44,
    marginTop: 30,
    marginBottom: 24,
    x: { domain: bars.map(({ type }) => type), label: null, padding: 0.25 },
    y: { label: null, nice: true },
    marks: [
      Plot.gridY({ stroke: frame.line, strokeOpacity: 1 }),
      Plot.axisX({ label: null, fontSize: 11 }),
      Plot.axisY({ label: null, tickFormat: "d" }),
      Plot.barY(bars, { x: "type", y: "count", fill: ({ type }: Bar) => typeColour(type), stroke: frame.soft, strokeWidth: 0.75, className: "type-bars" }),
      Plot.text(bars, {
        x: "type",
        y: "count",
        text: ({ count, share }: Bar) => `${format.integer(count)}\n${format.share(share)}`,
        lineAnchor: "bottom",
        dy: -4,
        fill: frame.soft,
      }),
    ],
  });
}
