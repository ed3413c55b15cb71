// How far points are from the surfaces of their primitives, for the model that is looked at.

import type { JSX } from "preact";
import { computed, effect, signal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import type { Counted } from "../engine/contract";
import type { ModelSource, SegmentationScene } from "../../worker/protocol";
import { engine } from "../engine/client";
import { latest } from "../engine/latest";
import { partnersOf, segmentationOf, segmentColours } from "../stage/colouring";
import { brush, setBrush, setBrushed, takeBrushBack } from "../stage/brush";
import { reports } from "../stage/reports";
import { where } from "../stage/where";
import { modelById } from "../state/models";
import { notify } from "../state/notices";
import { scene } from "../state/scene";
import { selectedModel, selectedPrimitive, togglePrimitive, type PrimitiveRef, type Side } from "../state/selection";
import * as format from "../ui/format";
import { Table, type Column } from "../ui/table";
import { UNSEGMENTED } from "../view/palette";
import { BrushLayer, startDrag, type Bins } from "./brush";
import { Chart } from "./figure";
import { decades, drawn, leading, Plot, tick, type Frame } from "./plot";

/** Points of one primitive whose distances lie in one interval, on top of those of the primitives before it. */
interface Block {
  readonly place: number;
  readonly bin: number;
  /** Bounds of the interval. */
  readonly low: number;
  readonly high: number;
  /** Number of points below this block in its bar, and with it. */
  readonly from: number;
  readonly to: number;
  readonly side: Side;
  readonly series: string;
  readonly colour: string;
  readonly number: number;
}

/** What is drawn of one side. */
interface Wanted {
  readonly side: Side;
  readonly series: string;
  readonly method: string | undefined;
  readonly segmentation: SegmentationScene;
  readonly places: readonly number[];
  readonly colours: readonly string[];
}

/** What is to be drawn: the engine is asked for its counts. */
interface Question {
  readonly source: ModelSource;
  readonly model: string;
  /** The selected primitive in words; absent where it is about all of them. */
  readonly primitive: string | undefined;
  readonly logarithmic: boolean;
  readonly sides: readonly Wanted[];
}

interface Half {
  readonly side: Side;
  readonly series: string;
  readonly blocks: readonly Block[];
  /** Points in each interval. */
  readonly counts: readonly number[];
}

interface Histogram extends Question {
  readonly edges: Float64Array;
  readonly halves: readonly Half[];
}

/** Intervals of a histogram. */
const BINS = 24;
/** Room beside the frame of the drawing, in pixels. */
const MARGINS = { left: 48, right: 16 } as const;

/** Most points lie close to their surface: on a linear axis they are all one bar. */
const logarithmic = signal(true);

const question = computed<Question | undefined>(() => {
  const state = scene.value;
  const model = selectedModel.value;
  const source = modelById(model)?.source;
  if (state.kind !== "ready" || model === undefined || source?.key !== state.scene.key) return undefined;
  const { method, rival } = state.scene;
  const selected = selectedPrimitive.value;
  const partners = selected && partnersOf(reports.value, selected);
  const methods = { truth: undefined, prediction: method, rival: rival?.method };
  const series = { truth: "Truth", prediction: method ?? "", rival: rival?.method ?? "" };
  const sides = (["truth", "prediction", "rival"] as const).flatMap((side): Wanted[] => {
    const segmentation = segmentationOf(state.scene, side);
    if (!segmentation) return [];
    const only = partners?.[side];
    const places = !partners ? segmentation.primitives.map((_, place) => place) : only === undefined ? [] : [only];
    const colours = segmentColours(side, reports.value, segmentation.primitives.length);
    return [{ side, series: series[side], method: methods[side], segmentation, places, colours }];
  });
  const primitive = selected && nameOf(selected, segmentationOf(state.scene, selected.side), series[selected.side]);
  return { source, model, primitive, logarithmic: logarithmic.value, sides };
});

/** The last answer. */
const histogram = signal<Histogram | undefined>(undefined);

/** Selections may change faster than they are counted. */
const count = latest(async (asked: Question | undefined) => {
  if (!asked) {
    histogram.value = undefined;
    return;
  }
  const { edges, counts } = await engine.run((api) => api.histogram(asked.source, countedOf(asked), BINS, asked.logarithmic));
  histogram.value = { ...asked, edges, halves: asked.sides.map((side, at) => halfOf(side, counts[at] ?? new Uint32Array(), edges)) };
});

function countedOf({ sides }: Question): Counted[] {
  return sides.map(({ method, places }) => ({ ...(method !== undefined && { method }), places: [...places] }));
}

/** The intervals of the range that is chosen. */
const chosen = computed<Bins | undefined>(() => {
  const [current, range] = [histogram.value, brush.value];
  if (!current || !range) return undefined;
  const nearest = (value: number) => {
    const away = Array.from(current.edges, (edge) => Math.abs(current.logarithmic ? Math.log(edge / value) : edge - value));
    return value === Infinity ? BINS : value <= (current.edges[0] ?? 0) ? 0 : away.indexOf(Math.min(...away));
  };
  const from = Math.min(BINS - 1, nearest(range.low));
  return { from, to: Math.max(from + 1, nearest(range.high)) };
});

/** Asks which points are in the intervals, for the picture. A range may move faster than it is answered. */
const find = latest(async ({ bins, asked }: { bins: Bins | undefined; asked: Histogram | undefined }) => {
  if (!bins || !asked) return;
  const { from, to } = bins;
  const found = await engine.run((api) => api.pointsInBins(asked.source, countedOf(asked), BINS, asked.logarithmic, from, to - 1));
  const points = Object.fromEntries(asked.sides.map(({ side }, at) => [side, found[at] ?? new Uint32Array()]));
  const counts = asked.sides.map(({ series }, at) => `${format.plural(found[at]?.length ?? 0, "point")} of ${series}`);
  const low = from === 0 ? "0" : bound(asked, from);
  setBrushed({ where: where.peek(), points, words: `Distances ${low} to ${bound(asked, to)}: ${counts.join(", ")}` });
});

function bound({ edges }: Histogram, at: number): string {
  return (edges[at] ?? 0).toPrecision(3);
}

/** Counts what is in view, and what comes into it, until the result is called. */
function follow(): () => void {
  const tell = (error: unknown) => notify(error instanceof Error ? error.message : String(error), "error");
  const ends = [
    effect(() => {
      count(question.value).catch(tell);
    }),
    effect(() => {
      find({ bins: chosen.value, asked: histogram.value }).catch(tell);
    }),
  ];
  return () => ends.forEach((end) => end());
}

function choose({ from, to }: Bins): void {
  const edges = histogram.peek()?.edges;
  if (!edges) return;
  if (from === 0 && to === BINS) takeBrushBack();
  // The first interval takes all that is smaller, the last all that is larger.
  else setBrush(from === 0 ? 0 : (edges[from] ?? 0), to === BINS ? Infinity : (edges[to] ?? 0));
}

/** Stacks the primitives' counts: a bar of blocks over each interval. */
function halfOf({ side, series, segmentation, places, colours }: Wanted, rows: Uint32Array, edges: Float64Array): Half {
  const heights = new Array<number>(BINS).fill(0);
  const blocks = places.flatMap((place, row) =>
    Array.from(rows.subarray(row * BINS, (row + 1) * BINS)).flatMap((points, bin): Block[] => {
      if (points === 0) return [];
      const from = heights[bin] ?? 0;
      heights[bin] = from + points;
      const number = segmentation.primitives[place]?.number ?? place + 1;
      const interval = { bin, low: edges[bin] ?? 0, high: edges[bin + 1] ?? 0 };
      return [{ ...interval, place, from, to: from + points, side, series, colour: colours[place + 1] ?? UNSEGMENTED, number }];
    }),
  );
  return { side, series, blocks, counts: heights };
}

function nameOf({ side, index }: PrimitiveRef, segmentation: SegmentationScene | undefined, series: string): string | undefined {
  const whose = { truth: "true primitive", prediction: "predicted primitive", rival: `primitive of ${series},` }[side];
  return segmentation && `${whose} ${segmentation.primitives[index]?.number ?? index + 1}`;
}

interface Row {
  readonly bin: number;
  readonly low: number;
  readonly high: number;
  /** Points per half, in their order. */
  readonly counts: readonly number[];
}

function rowsOf({ edges, logarithmic, halves }: Histogram): Row[] {
  return Array.from({ length: BINS }, (_, bin) => ({
    bin,
    // Everything smaller is in the first one.
    low: logarithmic && bin === 0 ? 0 : (edges[bin] ?? 0),
    high: edges[bin + 1] ?? 0,
    counts: halves.map(({ counts }) => counts[bin] ?? 0),
  }));
}

function columnsOf({ halves }: Histogram): Column<Row>[] {
  const length = (value: number) => value.toPrecision(3);
  return [
    { id: "low", head: "Distance", label: "distance", cell: ({ low, high }) => `${length(low)} to ${length(high)}`, sortBy: ({ low }) => low },
    ...halves.map(
      ({ series, side }, at): Column<Row> => ({
        id: side,
        head: series,
        label: `points of ${series}`,
        numeric: true,
        cell: ({ counts }) => format.integer(counts[at] ?? 0),
        sortBy: ({ counts }) => counts[at],
      }),
    ),
  ];
}

export function DistanceChart(): JSX.Element | null {
  useEffect(follow, []);
  const current = histogram.value;
  if (!current) return null;
  const title = `Distances to the surface, ${current.primitive ? `${current.primitive} of ` : ""}${current.model}`;
  const empty = current.halves.every(({ blocks }) => blocks.length === 0);
  if (empty) return <p class="empty">No distances: {title.toLowerCase()} has no surface to measure from.</p>;
  const brushing = {
    bins: chosen.value ?? { from: 0, to: BINS },
    count: BINS,
    ...MARGINS,
    words: (at: number) => (at === 0 ? "0" : bound(current, at)),
    onChange: choose,
  };
  return (
    <Chart
      name="distances"
      title={title}
      description={`Number of points by their distance to the surface of their primitive, in the units of the file. ${current.primitive ? "The selected primitive and its partner." : "Colours as in the view; select a primitive to see it alone."} Drag over the bars, or move the handles at either end with the arrow keys, to see the points of a range in the picture; Escape takes it back.`}
      draw={(frame) => draw(frame, current)}
      logarithmic={logarithmic}
      over={<BrushLayer {...brushing} />}
      onPress={(event) => startDrag(event, brushing)}
      table={() => <Table caption={title} columns={columnsOf(current)} rows={rowsOf(current)} keyOf={({ bin }) => String(bin)} />}
    />
  );
}

function draw(frame: Frame, { edges, logarithmic, halves }: Histogram): SVGSVGElement {
  const [low, high] = [edges[0] ?? 0, edges.at(-1) ?? 1];
  const blocks = halves.flatMap((half) => half.blocks);
  const names = halves.map(({ side }) => side);
  const series = halves.map((half) => ({ side: half.side, text: half.series }));
  return drawn(frame, {
    height: 60 + 120 * halves.length,
    marginLeft: MARGINS.left,
    marginTop: 12,
    marginBottom: 38,
    marginRight: MARGINS.right,
    x: { domain: [low, high], type: logarithmic ? "log" : "linear", label: "Distance →" },
    y: { label: null, nice: true },
    fy: { domain: names, axis: null, padding: 0.12 },
    marks: [
      Plot.gridY({ stroke: frame.line, strokeOpacity: 1, ticks: 4 }),
      Plot.axisX({ label: "Distance →", ticks: Math.max(2, Math.floor(frame.width / 90)), tickFormat: logarithmic ? decades(low, high) : tick }),
      Plot.axisY({ label: null, ticks: 4, tickFormat: format.shortCount }),
      Plot.rect(blocks, {
        fy: "side",
        x1: "low",
        x2: "high",
        y1: "from",
        y2: "to",
        insetLeft: 0.5,
        insetRight: 0.5,
        fill: "colour",
        className: "bins",
        title: ({ series: of, number, low, high, from, to }: Block) =>
          `${of}, primitive ${number}: ${format.integer(to - from)} points from ${low.toPrecision(3)} to ${high.toPrecision(3)}`,
        ...leading(blocks, ({ side, place }) => togglePrimitive({ side, index: place })),
      }),
      Plot.ruleY([0], { stroke: frame.soft }),
      Plot.text(series, { fy: "side", text: "text", frameAnchor: "top-right", fill: frame.ink, fontSize: 11, fontWeight: 600 }),
    ],
  });
}
