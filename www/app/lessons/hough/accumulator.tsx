// The accumulator as a heat map or as a relief, one square per cell. Click a cell, or walk with the
// arrow keys and choose with Enter.

import type { JSX } from "preact";
import { useSignal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { isDark } from "../../state/settings";
import { SEQUENTIAL, sample } from "../../view/palette";
import type { MaximumInfo, SliceInfo } from "../../../generated/engine/engine.js";

interface Props {
  readonly slice: SliceInfo;
  readonly heights: Float32Array;
  /** Votes at the top of the colour scale. */
  readonly top: number;
  readonly lit: Uint32Array;
  readonly chosen: number | undefined;
  readonly maxima: readonly MaximumInfo[];
  readonly relief: boolean;
  readonly onCell: (cell: number) => void;
}

const SIZE = 560;
/** Share of the height that the relief's highest cell rises by. */
const RISE = 0.3;

export function Accumulator(props: Props): JSX.Element {
  const { slice, heights, top, lit, chosen, maxima, relief, onCell } = props;
  const canvas = useRef<HTMLCanvasElement>(null);
  const cursor = useSignal(chosen ?? 0);
  const { rows, columns } = slice;
  const count = rows.count * columns.count;
  const dark = isDark();

  useEffect(() => {
    const context = canvas.current?.getContext("2d");
    if (!context) return;
    // Cells without votes.
    context.fillStyle = sample(SEQUENTIAL, 0);
    context.fillRect(0, 0, SIZE, SIZE);
    if (isEmpty(heights)) drawGrid(context, slice, ink(context.canvas));
    else if (relief) drawRelief(context, props);
    else drawMap(context, props);
  }, [slice, heights, top, lit, chosen, maxima, relief, dark]);

  const walk = (event: KeyboardEvent) => {
    const by = { ArrowLeft: -1, ArrowRight: 1, ArrowUp: columns.count, ArrowDown: -columns.count }[event.key];
    if (by !== undefined) {
      const to = cursor.value + by;
      if (to >= 0 && to < count) cursor.value = to;
      onCell(cursor.value);
    } else if (event.key === "Enter" || event.key === " ") onCell(cursor.value);
    else return;
    event.preventDefault();
    event.stopPropagation();
  };

  return (
    <div class="accumulator">
      <canvas
        ref={canvas}
        width={SIZE}
        height={SIZE}
        tabIndex={0}
        role="application"
        aria-label={`Accumulator of ${rows.count} by ${columns.count} cells. Arrow keys walk from cell to cell.`}
        onKeyDown={walk}
        onClick={(event) => {
          const box = event.currentTarget.getBoundingClientRect();
          if (relief) return;
          const column = Math.floor(((event.clientX - box.left) / box.width) * columns.count);
          const row = Math.floor((1 - (event.clientY - box.top) / box.height) * rows.count);
          const at = row * columns.count + column;
          if (at < 0 || at >= count) return;
          cursor.value = at;
          onCell(at);
        }}
      />
      <p class="hint">
        To the right: {columns.name}. Upwards: {rows.name}.{" "}
        {isEmpty(heights)
          ? `Each of the ${rows.count} by ${columns.count} cells is a range of surfaces. No point has voted yet.`
          : `Pale is many votes, up to ${top}; dark is none.`}
      </p>
    </div>
  );
}

function isEmpty(heights: Float32Array): boolean {
  return !heights.some((votes) => votes > 0);
}

/** Colours of what is drawn, from the style sheet: the grid lies on the page, not on a scale. */
function ink(canvas: HTMLCanvasElement): Record<"ground" | "line" | "text", string> {
  const style = getComputedStyle(canvas);
  const of = (name: string) => style.getPropertyValue(name).trim();
  return { ground: of("--surface"), line: of("--line"), text: of("--ink-soft") };
}

/** Cells before the first vote, and what lies along the axes. */
function drawGrid(context: CanvasRenderingContext2D, { rows, columns }: SliceInfo, colour: ReturnType<typeof ink>): void {
  context.fillStyle = colour.ground;
  context.fillRect(0, 0, SIZE, SIZE);
  context.strokeStyle = colour.line;
  context.lineWidth = 1;
  context.beginPath();
  // Every tenth line: of all of them nothing but grey would be seen.
  for (let column = 0; column <= columns.count; column += 10) {
    const x = (column / columns.count) * SIZE;
    context.moveTo(x, 0);
    context.lineTo(x, SIZE);
  }
  for (let row = 0; row <= rows.count; row += 10) {
    const y = (row / rows.count) * SIZE;
    context.moveTo(0, y);
    context.lineTo(SIZE, y);
  }
  context.stroke();
  context.fillStyle = colour.text;
  context.font = "18px system-ui, sans-serif";
  const end = ({ start, step, count }: SliceInfo["rows"], of: number) => (start + step * count * of).toPrecision(3);
  const halo = (text: string, x: number, y: number, align: CanvasTextAlign) => {
    context.textAlign = align;
    context.lineWidth = 6;
    context.strokeStyle = colour.ground;
    context.strokeText(text, x, y);
    context.fillText(text, x, y);
  };
  halo(end(columns, 0), 8, SIZE - 10, "left");
  halo(`${columns.name} →`, SIZE / 2, SIZE - 10, "center");
  halo(end(columns, 1), SIZE - 8, SIZE - 10, "right");
  halo(end(rows, 1), 8, 24, "left");
  context.save();
  context.translate(24, SIZE / 2);
  context.rotate(-Math.PI / 2);
  halo(`${rows.name} →`, 0, 0, "center");
  context.restore();
}

function drawMap(context: CanvasRenderingContext2D, { slice, heights, top, lit, chosen, maxima }: Props): void {
  const { rows, columns } = slice;
  const [width, height] = [SIZE / columns.count, SIZE / rows.count];
  const corner = (cell: number) => {
    const row = Math.floor(cell / columns.count);
    return [(cell % columns.count) * width, SIZE - (row + 1) * height] as const;
  };
  const colours = Array.from({ length: 65 }, (_, i) => sample(SEQUENTIAL, i / 64));
  heights.forEach((votes, cell) => {
    context.fillStyle = colours[Math.round(64 * Math.sqrt(Math.min(1, votes / Math.max(1, top))))] ?? "#000000";
    const [x, y] = corner(cell);
    context.fillRect(x, y, width + 0.5, height + 0.5);
  });
  context.fillStyle = "#ffffff";
  for (const cell of lit) {
    const [x, y] = corner(cell);
    context.fillRect(x + width * 0.15, y + height * 0.15, width * 0.7, height * 0.7);
  }
  context.lineWidth = 2.5;
  for (const { cell, kept } of maxima) {
    const [x, y] = corner(cell);
    context.strokeStyle = kept ? "#ff5a36" : "#9aa1a8";
    context.beginPath();
    if (kept) context.arc(x + width / 2, y + height / 2, width * 1.2, 0, 2 * Math.PI);
    else {
      context.moveTo(x, y);
      context.lineTo(x + width, y + height);
      context.moveTo(x + width, y);
      context.lineTo(x, y + height);
    }
    context.stroke();
  }
  if (chosen !== undefined) {
    const [x, y] = corner(chosen);
    context.lineWidth = 5;
    context.strokeStyle = "#000000";
    context.strokeRect(x - 3, y - 3, width + 6, height + 6);
    context.lineWidth = 2.5;
    context.strokeStyle = "#ffffff";
    context.strokeRect(x - 3, y - 3, width + 6, height + 6);
  }
}

/** Row behind row, each a profile that hides what lies behind it. */
function drawRelief(context: CanvasRenderingContext2D, { slice, heights, top, maxima }: Props): void {
  const { rows, columns } = slice;
  const kept = new Map(maxima.map((each) => [each.cell, each.kept]));
  const depth = SIZE * (1 - RISE) - 8;
  const width = SIZE / columns.count;
  for (let row = rows.count - 1; row >= 0; row -= 1) {
    const base = SIZE - 4 - (row / rows.count) * depth;
    const level = (column: number) => base - ((heights[row * columns.count + column] ?? 0) / Math.max(1, top)) * SIZE * RISE;
    const shift = (row / rows.count) * 0.12 * SIZE;
    const x = (column: number) => shift + (column + 0.5) * width * 0.88;
    context.beginPath();
    context.moveTo(x(0), base);
    for (let column = 0; column < columns.count; column += 1) context.lineTo(x(column), level(column));
    context.lineTo(x(columns.count - 1), base);
    context.fillStyle = sample(SEQUENTIAL, 0.15 + 0.25 * (1 - row / rows.count));
    context.fill();
    context.lineWidth = 1;
    context.strokeStyle = sample(SEQUENTIAL, 0.95);
    context.stroke();
    for (let column = 0; column < columns.count; column += 1) {
      const peak = kept.get(row * columns.count + column);
      if (peak === undefined) continue;
      context.beginPath();
      context.arc(x(column), level(column), peak ? 6 : 2.5, 0, 2 * Math.PI);
      context.fillStyle = peak ? "#ff5a36" : "#9aa1a8";
      context.fill();
    }
  }
}
