// Methods against protocols: the mean over the models with how certain it is, and the ranks.

import type { JSX } from "preact";
import type { FieldSums } from "../../worker/protocol";
import type { FigureInfo, FigureScale } from "../engine/contract";
import { MISSING, plural } from "../ui/format";
import { Table, type Column } from "../ui/table";
import { headOf, ranksOf, written, type Spread } from "./figures";

type Row = FieldSums["spreads"][number];

interface Props {
  readonly caption: string;
  readonly figures: readonly FigureInfo[];
  readonly spreads: FieldSums["spreads"];
  readonly scale: FigureScale;
  /** Whether places are told, and where they change against those of the first figure. */
  readonly ranked: boolean;
}

export function MeansTable({ caption, figures, spreads, scale, ranked }: Props): JSX.Element {
  const ranks = figures.map((figure) => ranksOf(spreads, figure));
  const columns: readonly Column<Row>[] = [
    {
      id: "method",
      head: "Method",
      label: "method",
      cell: ({ method, models }) => (
        <>
          {method}, {plural(models, "model")}
          {models > 1 && (
            <>
              <small class="aside">95 % interval</small>
              <small class="aside">median</small>
              <small class="aside">quartiles</small>
            </>
          )}
        </>
      ),
      sortBy: ({ method }) => method,
    },
    ...figures.map(
      (figure, place): Column<Row> => ({
        id: figure.key,
        head: headOf(figure, scale),
        label: figure.title,
        numeric: true,
        cell: (row) => (
          <Cell
            figure={figure}
            row={row}
            rank={ranked && spreads.length > 1 ? ranks[place]?.get(row.method) : undefined}
            first={ranks[0]?.get(row.method)}
          />
        ),
        sortBy: (row) => spreadOf(row, figure)?.mean,
      }),
    ),
  ];
  return <Table className="field" caption={caption} columns={columns} rows={spreads} keyOf={({ method }) => method} />;
}

function spreadOf({ figures }: Row, { key }: FigureInfo): Spread | null | undefined {
  return figures.find(({ figure }) => figure === key)?.spread;
}

interface CellProps {
  readonly figure: FigureInfo;
  readonly row: Row;
  readonly rank: number | undefined;
  /** The place by the first figure. */
  readonly first: number | undefined;
}

function Cell({ figure, row, rank, first }: CellProps): JSX.Element {
  const spread = spreadOf(row, figure);
  if (!spread) return <>{written(figure, null)}</>;
  const { mean, interval, median, lowerQuartile, upperQuartile, count } = spread;
  return (
    <>
      <span class="mean">
        {rank !== undefined && <Rank rank={rank} first={first} />}
        {written(figure, mean)}
      </span>
      {row.models > 1 && (
        <>
          <small class="aside">{range(figure, interval)}</small>
          <small class="aside">{written(figure, median)}</small>
          <small class="aside">{range(figure, [lowerQuartile, upperQuartile])}</small>
        </>
      )}
      {count < row.models && (
        <small class="aside">
          of {count} of {plural(row.models, "model")}
        </small>
      )}
    </>
  );
}

function range(figure: FigureInfo, ends: readonly [number, number] | null): string {
  return ends ? `${written(figure, ends[0])} – ${written(figure, ends[1])}` : MISSING;
}

function Rank({ rank, first }: { rank: number; first: number | undefined }): JSX.Element {
  const moved = first === undefined || rank === first ? undefined : rank < first ? "up" : "down";
  return (
    <span class="rank" data-moved={moved}>
      <span class="visually-hidden">place </span>
      {rank}
      {moved && <span aria-hidden="true">{moved === "up" ? "▲" : "▼"}</span>}
      {moved && <span class="visually-hidden">, {moved} from place {first}</span>}
    </span>
  );
}
