// How many surfaces of each type there are, and how many each method found.

import type { JSX } from "preact";
import type { SurfaceType } from "../engine/contract";
import type { PrimitiveRef, Side } from "../state/selection";
import { count, words } from "../ui/columns";
import { Table, type Column } from "../ui/table";
import { UNSEGMENTED } from "../view/palette";
import { Chart } from "./figure";
import { drawn, leading, legend, Plot, type Frame } from "./plot";
import { goTo, methodColour, scope, scopeText, scoredInScope, type Scored } from "./scope";
import { TYPES, typeName } from "./surface-types";

const TRUTH = "Truth";

/** Primitives of one type in one model, or a single one: a slice of a bar. */
interface Slice {
  readonly type: string;
  readonly series: string;
  readonly count: number;
  readonly title: string;
  readonly go: () => void;
}

interface Bar {
  readonly type: string;
  readonly counts: Readonly<Record<string, number>>;
}

function slicesOf(scored: Scored, series: string, side: Side, types: readonly (SurfaceType | null)[]): Slice[] {
  const { model, method } = scored;
  const slice = (type: string, count: number, title: string, primitive?: PrimitiveRef): Slice => ({
    type,
    series,
    count,
    title,
    go: () => goTo(model, method, primitive),
  });
  if (scope.value === "one") {
    return types.map((type, index) => slice(typeName(type), 1, `${typeName(type)}, ${series}, primitive ${index + 1} of ${model}`, { side, index }));
  }
  return TYPES.flatMap((name) => {
    const count = types.filter((type) => typeName(type) === name).length;
    return count > 0 ? [slice(name, count, `${model}: ${count} of type ${name}, ${series}`)] : [];
  });
}

export function TypesChart(): JSX.Element {
  const scored = scoredInScope.value;
  const methods = [...new Set(scored.map(({ method }) => method))];
  const firsts = scored.filter(({ model }, at) => scored.findIndex((other) => other.model === model) === at);
  const slices = [
    ...firsts.flatMap((first) => slicesOf(first, TRUTH, "truth", first.report.primitives.map(({ type }) => type))),
    ...scored.flatMap((own) => slicesOf(own, seriesOf(own.method), "prediction", own.report.predictions.map(({ type }) => type))),
  ];
  const series = [TRUTH, ...methods.map(seriesOf)];
  const used = TYPES.filter((type) => slices.some((slice) => slice.type === type));
  const total = (type: string, name: string) =>
    slices.reduce((sum, slice) => (slice.type === type && slice.series === name ? sum + slice.count : sum), 0);
  const bars = used.map((type): Bar => ({ type, counts: Object.fromEntries(series.map((name) => [name, total(type, name)])) }));
  const title = `Surface types, ${scopeText.value}`;
  return (
    <Chart
      name="types"
      title={title}
      description={`Number of primitives of each type. Each slice is a ${scope.value === "one" ? "primitive" : "model"}.`}
      draw={(frame) => draw(frame, slices, bars, series)}
      table={() => <Table caption={title} columns={columnsOf(series)} rows={bars} keyOf={({ type }) => type} />}
    />
  );
}

/** A method may be called like the truth. */
function seriesOf(method: string): string {
  return method === TRUTH ? `${method} (method)` : method;
}

function columnsOf(series: readonly string[]): Column<Bar>[] {
  return [
    words("type", "Type", ({ type }) => type),
    ...series.map((name) => count<Bar>(name, name, ({ counts }) => counts[name] ?? 0, { label: name })),
  ];
}

function draw(frame: Frame, slices: readonly Slice[], bars: readonly Bar[], series: readonly string[]): SVGSVGElement {
  const colour = (name: string) => (name === TRUTH ? UNSEGMENTED : methodColour(name));
  const marginLeft = 40;
  const keys = legend(series.map((text) => ({ text, colour: colour(text) })), frame, marginLeft);
  const sums = bars.flatMap(({ type, counts }) => series.map((name) => ({ type, series: name, count: counts[name] ?? 0 })));
  return drawn(frame, {
    height: 240 + keys.height,
    marginLeft,
    marginTop: keys.height + 4,
    marginBottom: 24,
    fx: { domain: bars.map(({ type }) => type), label: null, padding: 0.12 },
    x: { domain: series, axis: null, padding: 0.1 },
    y: { label: null, nice: true },
    marks: [
      Plot.gridY({ stroke: frame.line, strokeOpacity: 1 }),
      Plot.axisFx({ anchor: "bottom", label: null, fontSize: 11 }),
      Plot.axisY({ label: null, tickFormat: "d" }),
      Plot.barY(
        slices,
        Plot.stackY({
          fx: "type",
          x: "series",
          y: "count",
          fill: ({ series: name }: Slice) => colour(name),
          stroke: frame.surface,
          strokeWidth: 0.5,
          className: "slices",
          title: "title",
          ...leading(slices, ({ go }) => go()),
        }),
      ),
      Plot.text(sums, { fx: "type", x: "series", y: "count", text: ({ count }: { count: number }) => String(count), dy: -7, fill: frame.soft }),
      ...keys.marks,
    ],
  });
}
