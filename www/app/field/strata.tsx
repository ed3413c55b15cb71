// True primitives by what they are and by the conditions of their models: where a method wins and loses.

import type { JSX } from "preact";
import { useEffect } from "preact/hooks";
import { infoOf } from "../../shared/formats/field-sums.mjs";
import type { FieldStrata } from "../../worker/protocol";
import { Chart } from "../charts/figure";
import { drawn, legend, Plot, type Frame } from "../charts/plot";
import { methodColour } from "../charts/scope";
import type { FigureInfo } from "../engine/contract";
import * as format from "../ui/format";
import { count, words } from "../ui/columns";
import { Table, type Column } from "../ui/table";
import { FIGURES_OF_FIT, headOf, PROTOCOLS_OF_FIELD, written } from "./figures";
import { followStrata, scale, strata } from "./state";

type Row = FieldStrata["primitives"][number];
type Conditioned = FieldStrata["figures"][number];

export default function StrataView(): JSX.Element {
  useEffect(followStrata, []);
  const found = strata.value;
  if (!found) return <p class="empty">Telling the primitives apart…</p>;
  const { title, how } = infoOf(found.by);
  return (
    <>
      <p class="note">
        {title}. {how}
      </p>
      <StrataChart found={found} />
      <StrataTable found={found} />
      {found.figures.length > 0 && (
        <>
          <ConditionedTable caption={`Protocols by ${found.by}, mean over models`} found={found} figures={PROTOCOLS_OF_FIELD} />
          <ConditionedTable caption={`Figures of fit by ${found.by}, mean over models`} found={found} figures={FIGURES_OF_FIT} />
        </>
      )}
    </>
  );
}

function StrataTable({ found: { by, primitives } }: { found: FieldStrata }): JSX.Element {
  const columns: readonly Column<Row>[] = [
    words("stratum", infoOf(by).title, ({ stratum }) => stratum),
    words("method", "Method", ({ method }) => method),
    count("models", "Models", ({ models }) => models),
    count("primitives", "Primitives", ({ primitives: number }) => number),
    {
      id: "iou",
      head: "Mean IoU",
      label: "mean IoU",
      numeric: true,
      cell: ({ iou }) => (
        <>
          {iou ? iou.mean.toFixed(4) : format.MISSING}
          {iou?.interval && (
            <small class="aside" title="Bootstrap 95 % interval of the mean">
              {iou.interval[0].toFixed(4)} – {iou.interval[1].toFixed(4)}
            </small>
          )}
        </>
      ),
      sortBy: ({ iou }) => iou?.mean,
      share: ({ iou }) => iou?.mean,
    },
    {
      id: "median",
      head: "Median IoU",
      label: "median IoU",
      numeric: true,
      cell: ({ iou }) => (
        <>
          {iou?.median.toFixed(4) ?? format.MISSING}
          {iou && (
            <small class="aside" title="Quartiles">
              {iou.lowerQuartile.toFixed(4)} – {iou.upperQuartile.toFixed(4)}
            </small>
          )}
        </>
      ),
      sortBy: ({ iou }) => iou?.median,
    },
    {
      id: "found",
      head: "IoU > 0.5",
      label: "share with IoU above 0.5",
      numeric: true,
      cell: ({ found }) => format.share(found),
      sortBy: ({ found }) => found,
    },
  ];
  return (
    <Table
      className="field"
      caption={`True primitives by ${by}: IoU with the one-to-one partner, 0 without one`}
      columns={columns}
      rows={primitives}
      keyOf={({ method, stratum }) => `${method} ${stratum}`}
    />
  );
}

interface ConditionedProps {
  readonly caption: string;
  readonly found: FieldStrata;
  readonly figures: readonly FigureInfo[];
}

/** The figures of the models of each stratum. */
function ConditionedTable({ caption, found, figures }: ConditionedProps): JSX.Element {
  const columns: readonly Column<Conditioned>[] = [
    words("stratum", infoOf(found.by).title, ({ stratum }) => stratum),
    words("method", "Method", ({ method }) => method),
    count("models", "Models", ({ models }) => models),
    ...figures.map((figure): Column<Conditioned> => {
      const mean = ({ figures: own }: Conditioned) => own.find((each) => each.figure === figure.key)?.spread?.mean;
      return {
        id: figure.key,
        head: headOf(figure, scale.value),
        label: figure.title,
        numeric: true,
        cell: (row) => written(figure, mean(row)),
        sortBy: mean,
      };
    }),
  ];
  return (
    <Table
      className="field"
      caption={caption}
      columns={columns}
      rows={found.figures}
      keyOf={({ method, stratum }) => `${method} ${stratum}`}
    />
  );
}

function StrataChart({ found }: { found: FieldStrata }): JSX.Element {
  const title = `IoU of true primitives by ${found.by}`;
  return (
    <Chart
      name={`strata-${found.by}`}
      title={title}
      description="Bar: mean IoU with the one-to-one partner, 0 without one; whisker: its bootstrap 95 % interval; diamond: median; below the bars the number of primitives."
      draw={(frame) => draw(frame, found)}
      table={() => <StrataTable found={found} />}
    />
  );
}

function draw(frame: Frame, { by, primitives }: FieldStrata): SVGSVGElement {
  const methods = [...new Set(primitives.map(({ method }) => method))];
  const there = infoOf(by).strata.filter((stratum) => primitives.some((row) => row.stratum === stratum));
  const marginLeft = 40;
  const keys = legend(methods.map((text) => ({ text, colour: methodColour(text) })), frame, marginLeft);
  const place = { fx: "stratum", x: "method" } as const;
  const known = primitives.filter(({ iou }) => iou);
  const certain = primitives.filter(({ iou }) => iou?.interval);
  return drawn(frame, {
    height: 260 + keys.height,
    marginLeft,
    marginTop: keys.height + 4,
    marginBottom: 58,
    fx: { domain: there, label: null, padding: 0.12, axis: null },
    x: { domain: methods, axis: null, padding: 0.15 },
    y: { label: null, domain: [0, 1] },
    marks: [
      Plot.gridY({ stroke: frame.line, strokeOpacity: 1 }),
      Plot.axisFx({ anchor: "bottom", label: null, fontSize: 11, lineWidth: frame.width / there.length / 13, dy: 14 }),
      Plot.axisY({ label: null }),
      Plot.barY(known, {
        ...place,
        y: ({ iou }: Row) => iou?.mean,
        fill: ({ method }: Row) => methodColour(method),
        stroke: frame.ink,
        className: "strata-bars",
        title: ({ stratum, method, primitives: number, iou }: Row) => `${stratum}, ${method}: mean IoU ${iou?.mean.toFixed(4)} of ${format.plural(number, "primitive")}`,
      }),
      Plot.ruleX(certain, { ...place, y1: ({ iou }: Row) => iou?.interval?.[0], y2: ({ iou }: Row) => iou?.interval?.[1], stroke: frame.ink, strokeWidth: 1.5 }),
      Plot.dot(known, { ...place, y: ({ iou }: Row) => iou?.median, symbol: "diamond", r: 4, fill: frame.surface, stroke: frame.ink }),
      Plot.text(known, { ...place, y: 0, text: ({ primitives: number }: Row) => format.shortCount(number), dy: 9, fontSize: 10, fill: frame.soft }),
      Plot.ruleY([0], { stroke: frame.soft }),
      ...keys.marks,
    ],
  });
}
