// How far points are from the surfaces of their primitives, for the model that is looked at.

import type { JSX } from "preact";
import { computed, signal } from "@preact/signals";
import type { SegmentationScene } from "../../worker/protocol";
import { partnersOf, segmentationOf, segmentColours } from "../stage/colouring";
import { reports } from "../stage/reports";
import { scene } from "../state/scene";
import { selectedModel, selectedPrimitive, togglePrimitive, type PrimitiveRef, type Side } from "../state/selection";
import * as format from "../ui/format";
import { Table, type Column } from "../ui/table";
import { UNSEGMENTED } from "../view/palette";
import { BINS, binsTo, blocksOf, largest, type Bins, type Block } from "./bins";
import { Chart } from "./figure";
import { decades, drawn, leading, Plot, tick, type Frame } from "./plot";

interface Coloured extends Block {
  readonly side: Side;
  readonly series: string;
  readonly colour: string;
  readonly number: number;
}

interface Half {
  readonly side: Side;
  readonly series: string;
  readonly blocks: readonly Coloured[];
}

interface Histogram {
  readonly model: string;
  /** The selected primitive in words; absent where it is about all of them. */
  readonly primitive: string | undefined;
  readonly bins: Bins;
  readonly halves: readonly Half[];
}

/** Most points lie close to their surface: on a linear axis they are all one bar. */
const logarithmic = signal(true);

const histogram = computed<Histogram | undefined>(() => {
  const state = scene.value;
  const model = selectedModel.value;
  if (state.kind !== "ready" || model === undefined) return undefined;
  const { method, rival } = state.scene;
  const selected = selectedPrimitive.value;
  const partners = selected && partnersOf(reports.value, selected);
  const series = { truth: "Truth", prediction: method ?? "", rival: rival?.method ?? "" };
  const wanted = (["truth", "prediction", "rival"] as const).flatMap((side) => {
    const segmentation = segmentationOf(state.scene, side);
    if (!segmentation) return [];
    const only = partners?.[side];
    const places = !partners ? segmentation.primitives.map((_, place) => place) : only === undefined ? [] : [only];
    return [{ side, series: series[side], segmentation, places, colours: segmentColours(side, reports.value, segmentation.primitives.length) }];
  });
  const limit = Math.max(0, ...wanted.map(({ segmentation, places }) => largest(segmentation, places)));
  const bins = binsTo(limit, logarithmic.value);
  return {
    model,
    primitive: selected && nameOf(selected, segmentationOf(state.scene, selected.side), series[selected.side]),
    bins,
    halves: wanted.map(({ side, series, segmentation, places, colours }) => ({
      side,
      series,
      blocks: blocksOf(segmentation, places, bins).map((block) => ({
        ...block,
        side,
        series,
        colour: colours[block.place + 1] ?? UNSEGMENTED,
        number: segmentation.primitives[block.place]?.number ?? block.place + 1,
      })),
    })),
  };
});

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

function rowsOf({ bins: { edges, logarithmic }, halves }: Histogram): Row[] {
  return Array.from({ length: BINS }, (_, bin) => ({
    bin,
    // Everything smaller is in the first one.
    low: logarithmic && bin === 0 ? 0 : (edges[bin] ?? 0),
    high: edges[bin + 1] ?? 0,
    counts: halves.map(({ blocks }) => blocks.reduce((most, block) => (block.bin === bin ? Math.max(most, block.to) : most), 0)),
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
  const current = histogram.value;
  if (!current) return null;
  const title = `Distances to the surface, ${current.primitive ? `${current.primitive} of ` : ""}${current.model}`;
  const empty = current.halves.every(({ blocks }) => blocks.length === 0);
  if (empty) return <p class="empty">No distances: {title.toLowerCase()} has no surface to measure from.</p>;
  return (
    <Chart
      name="distances"
      title={title}
      description={`Number of points by their distance to the surface of their primitive, in the units of the file. ${current.primitive ? "The selected primitive and its partner." : "Colours as in the view; select a primitive to see it alone."}`}
      draw={(frame) => draw(frame, current)}
      logarithmic={logarithmic}
      table={() => <Table caption={title} columns={columnsOf(current)} rows={rowsOf(current)} keyOf={({ bin }) => String(bin)} />}
    />
  );
}

function draw(frame: Frame, { bins, halves }: Histogram): SVGSVGElement {
  const [low, high] = [bins.edges[0] ?? 0, bins.edges.at(-1) ?? 1];
  const blocks = halves.flatMap((half) => half.blocks);
  const names = halves.map(({ side }) => side);
  const series = halves.map((half) => ({ side: half.side, text: half.series }));
  return drawn(frame, {
    height: 60 + 120 * halves.length,
    marginLeft: 48,
    marginTop: 12,
    marginBottom: 38,
    marginRight: 16,
    x: { domain: [low, high], type: bins.logarithmic ? "log" : "linear", label: "Distance →" },
    y: { label: null, nice: true },
    fy: { domain: names, axis: null, padding: 0.12 },
    marks: [
      Plot.gridY({ stroke: frame.line, strokeOpacity: 1, ticks: 4 }),
      Plot.axisX({ label: "Distance →", ticks: Math.max(2, Math.floor(frame.width / 90)), tickFormat: bins.logarithmic ? decades(low, high) : tick }),
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
        title: ({ series: of, number, low, high, from, to }: Coloured) =>
          `${of}, primitive ${number}: ${format.integer(to - from)} points from ${low.toPrecision(3)} to ${high.toPrecision(3)}`,
        ...leading(blocks, ({ side, place }) => togglePrimitive({ side, index: place })),
      }),
      Plot.ruleY([0], { stroke: frame.soft }),
      Plot.text(series, { fy: "side", text: "text", frameAnchor: "top-right", fill: frame.ink, fontSize: 11, fontWeight: 600 }),
    ],
  });
}
