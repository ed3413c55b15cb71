// Accuracy against time: what a better answer costs.

import type { JSX } from "preact";
import { Chart } from "../charts/figure";
import { decades, drawn, leading, Plot, type Frame } from "../charts/plot";
import { words } from "../ui/columns";
import { Table, type Column } from "../ui/table";
import { meanOf, type Figure } from "./columns";
import { showMethod } from "./state";
import { summaryOf, type Row } from "./table-data";
import { timeOf, type Time } from "./time";

interface Dot {
  readonly id: string;
  readonly name: string;
  readonly time: Time;
  readonly value: number;
  readonly interval: readonly [number, number] | null;
}

/** By shape, and the lighter one for what runs on the machine itself: colour alone tells nothing. */
const SYMBOLS = { wasm: "circle", native: "square" } as const;

export function TimePlot({ rows, set, figure }: { rows: readonly Row[]; set: string; figure: Figure }): JSX.Element | null {
  const dots = rows.flatMap((row): Dot[] => {
    const [time, spread] = [timeOf(row, set), meanOf(figure, summaryOf(row, set))];
    return time && time.seconds > 0 && spread ? [{ id: row.id, name: row.method.name, time, value: spread.mean, interval: spread.interval }] : [];
  });
  if (dots.length === 0) return null;
  const title = `${figure.title} against time`;
  return (
    <Chart
      name="accuracy-against-time"
      title={title}
      description={`Circles ran as wasm, one thread in a browser or Node; squares natively. Each time is of the machine named in its tooltip and the table: compare them with care. Bars: 95 % interval of the mean. ${figure.better === "higher" ? "Up" : "Down"} and left is better.`}
      draw={(frame) => draw(frame, dots, figure)}
      table={() => <Table caption={title} columns={columnsOf(figure)} rows={dots} keyOf={({ id }) => id} />}
    />
  );
}

function columnsOf(figure: Figure): Column<Dot>[] {
  return [
    words("method", "Method", ({ name }) => name),
    { id: "seconds", head: "Seconds a cloud", label: "seconds", numeric: true, cell: ({ time }) => `${time.text} (${time.what})`, sortBy: ({ time }) => time.seconds },
    words("platform", "Ran as", ({ time }) => time.platform),
    words("machine", "On", ({ time }) => time.machine),
    { id: "value", head: figure.title, label: figure.title, numeric: true, cell: ({ value }) => figure.write(value), sortBy: ({ value }) => value },
  ];
}

/** Room beyond the first and the last, as a factor, so that names fit. */
const ROOM = 2.5;
/** Dots closer than this share of either axis have their names one below the other. */
const NEAR = 0.12;
const LINE = 14;

function draw(frame: Frame, dots: readonly Dot[], figure: Figure): SVGSVGElement {
  const times = dots.map(({ time }) => time.seconds);
  const [low, high] = [Math.min(...times) / ROOM, Math.max(...times) * ROOM];
  const middle = Math.sqrt(low * high);
  const values = dots.map(({ value }) => value);
  const height = Math.max(...values) - Math.min(...values) || 1;
  const isNear = (one: Dot, other: Dot) =>
    Math.abs(Math.log(one.time.seconds / other.time.seconds)) < NEAR * Math.log(high / low) && Math.abs(one.value - other.value) < NEAR * height;
  const name = (dot: Dot, place: number) => {
    const toTheRight = dot.time.seconds < middle;
    const others = dots.slice(0, place).filter((other) => isNear(dot, other)).length;
    return Plot.text([dot], {
      x: ({ time }: Dot) => time.seconds,
      y: "value",
      text: "name",
      textAnchor: toTheRight ? "start" : "end",
      dx: toTheRight ? 10 : -10,
      dy: -8 - LINE * others,
      fontSize: 11,
    });
  };
  return drawn(frame, {
    height: 280,
    marginLeft: 52,
    marginBottom: 36,
    marginTop: 36,
    x: { type: "log", domain: [low, high], label: null },
    y: { label: null, nice: true },
    symbol: { domain: Object.keys(SYMBOLS), range: Object.values(SYMBOLS) },
    marks: [
      Plot.gridY({ stroke: frame.line, strokeOpacity: 1 }),
      Plot.gridX({ stroke: frame.line, strokeOpacity: 1, ticks: 4 }),
      Plot.axisX({ label: "Seconds a cloud (logarithmic) →", labelAnchor: "right", tickFormat: decades(low, high), ticks: 4 }),
      Plot.axisY({ label: `↑ ${figure.title}`, ticks: 5 }),
      Plot.ruleX(
        dots.filter(({ interval }) => interval !== null),
        { x: ({ time }: Dot) => time.seconds, y1: ({ interval }: Dot) => interval?.[0], y2: ({ interval }: Dot) => interval?.[1], stroke: frame.soft, strokeWidth: 1.5 },
      ),
      Plot.dot(dots, {
        x: ({ time }: Dot) => time.seconds,
        y: "value",
        r: 6,
        symbol: ({ time }: Dot) => time.platform,
        fill: ({ time }: Dot) => (time.platform === "wasm" ? frame.accent : frame.surface),
        stroke: frame.ink,
        strokeWidth: 1.5,
        title: ({ name: called, time, value }: Dot) => `${called}: ${figure.title} ${figure.write(value)}, ${time.text} s (${time.what}), ${time.platform}, ${time.machine}`,
        ...leading(dots, ({ id }) => showMethod(id)),
      }),
      ...dots.map(name),
    ],
  });
}
