// Types of the true primitives against the types of their matches.

import type { JSX } from "preact";
import { placeOfMatch } from "../state/matches";
import { selectedModel, selectedPrimitive } from "../state/selection";
import { Table, type Column } from "../ui/table";
import { sample, SEQUENTIAL } from "../view/palette";
import { Chart } from "./figure";
import { drawn, leading, Plot, type Frame } from "./plot";
import { chartedMethod, goTo, ofChartedMethod, scopeText } from "./scope";
import { typeName } from "./surface-types";

const MISSED = "Missed";

interface Member {
  readonly model: string;
  readonly method: string;
  readonly place: number;
}

interface Cell {
  readonly truth: string;
  readonly match: string;
  readonly count: number;
  readonly members: readonly Member[];
}

/** The engine's tables of the models, added up, with the primitives that each cell counts. */
function cells(): Cell[] {
  const counts = new Map<string, Cell>();
  const members = new Map<string, Member[]>();
  for (const { model, method, report } of ofChartedMethod.value) {
    const { truth: rows, match: columns, counts: table } = report.hidden.types;
    rows.forEach((truth, row) =>
      columns.forEach((match, column) => {
        const key = `${truth} ${match}`;
        const count = (counts.get(key)?.count ?? 0) + (table[row]?.[column] ?? 0);
        const list = members.get(key) ?? [];
        members.set(key, list);
        counts.set(key, { truth, match, count, members: list });
      }),
    );
    report.primitives.forEach(({ type }, place) => {
      const at = placeOfMatch(report, place);
      const match = at === undefined ? MISSED : typeName(report.predictions[at]?.type);
      members.get(`${typeName(type)} ${match}`)?.push({ model, method, place });
    });
  }
  const all = [...counts.values()];
  const rows = new Set(all.filter(({ count }) => count > 0).map(({ truth }) => truth));
  const columns = new Set([...rows, ...all.filter(({ count }) => count > 0).map(({ match }) => match)]);
  return all.filter(({ truth, match }) => rows.has(truth) && columns.has(match));
}

/** Goes to the first primitive of the cell, or from one of them to the next. */
function step({ members }: Cell): void {
  const current = selectedPrimitive.peek();
  const at = members.findIndex(
    ({ model, place }) => model === selectedModel.peek() && current?.side === "truth" && current.index === place,
  );
  const next = members[(at + 1) % members.length];
  if (next) goTo(next.model, next.method, { side: "truth", index: next.place });
}

interface Row {
  readonly truth: string;
  readonly cells: readonly Cell[];
}

export function ConfusionChart(): JSX.Element {
  const all = cells();
  const matches = [...new Set(all.map(({ match }) => match))];
  const rows = [...new Set(all.map(({ truth }) => truth))].map(
    (truth): Row => ({ truth, cells: all.filter((cell) => cell.truth === truth) }),
  );
  const title = `Type confusion of ${chartedMethod.value}, ${scopeText.value}`;
  const columns: Column<Row>[] = [
    { id: "truth", head: "True type", label: "true type", cell: ({ truth }) => truth },
    ...matches.map(
      (match): Column<Row> => ({
        id: match,
        head: match,
        label: match,
        numeric: true,
        cell: (row) => <CellButton cell={row.cells.find((cell) => cell.match === match)} />,
      }),
    ),
  ];
  return (
    <Chart
      name="confusion"
      title={title}
      description="True primitives by their type (rows) and the type of their match (columns). Clicking a cell again goes on to its next primitive."
      draw={(frame) => draw(frame, all)}
      table={() => <Table caption={title} columns={columns} rows={rows} keyOf={({ truth }) => truth} />}
    />
  );
}

function CellButton({ cell }: { cell: Cell | undefined }): JSX.Element {
  if (!cell || cell.count === 0) return <>0</>;
  return (
    <button
      type="button"
      class="figure-link"
      aria-label={`${cell.count}: go to a ${cell.truth} matched as ${cell.match}`}
      onClick={() => step(cell)}
    >
      {cell.count}
    </button>
  );
}

/** Where the map of colours turns from dark to light. */
const LIGHT_FROM = 0.55;

function draw(frame: Frame, all: readonly Cell[]): SVGSVGElement {
  const largest = Math.max(1, ...all.map(({ count }) => count));
  const share = ({ count }: Cell) => Math.sqrt(count / largest);
  const rows = new Set(all.map(({ truth }) => truth)).size;
  const filled = all.filter(({ count }) => count > 0);
  const place = { x: "match", y: "truth" } as const;
  const domains = { x: [...new Set(all.map(({ match }) => match))], y: [...new Set(all.map(({ truth }) => truth))] };
  return drawn(frame, {
    height: 70 + 38 * rows,
    marginLeft: 84,
    marginTop: 40,
    marginBottom: 8,
    marginRight: 8,
    x: { domain: domains.x, axis: "top", label: "Type of the match →", tickSize: 0, padding: 0.04 },
    y: { domain: domains.y, label: "True type", tickSize: 0, padding: 0.04 },
    marks: [
      Plot.cell(all, { ...place, fill: "none", stroke: frame.line }),
      Plot.cell(filled, {
        ...place,
        fill: (cell: Cell) => sample(SEQUENTIAL, share(cell)),
        stroke: ({ truth, match }: Cell) => (truth === match ? frame.ink : "none"),
        className: "cells",
        title: ({ count, truth, match }: Cell) => `${count} of type ${truth} matched as ${match}`,
        ...leading(filled, step),
      }),
      Plot.text(all, {
        ...place,
        text: ({ count }: Cell) => String(count),
        fill: (cell: Cell) => (cell.count === 0 ? frame.soft : share(cell) > LIGHT_FROM ? "#000000" : "#ffffff"),
        fontSize: 12,
        pointerEvents: "none",
      }),
    ],
  });
}
