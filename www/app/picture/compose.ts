// A picture to keep: the views in the size wanted, named, with a legend below them.

import { endOfScale, type ColourMode, type Shown } from "../stage/colouring";
import { fixedKey, nameOf, primitiveKey, type KeyEntry } from "../stage/key";
import type { Side } from "../state/selection";
import { SEQUENTIAL } from "../view/palette";
import type { PointView } from "../view/point-view";

export type Background = "white" | "transparent" | "dark";

export interface Wish {
  /** Of the whole picture, legend and all, in pixels. */
  readonly width: number;
  readonly height: number;
  readonly background: Background;
  readonly legend: boolean;
}

/** What is in view, in the page's terms. */
export interface Subject extends Shown {
  readonly model: string;
  readonly mode: ColourMode;
  readonly sides: readonly [Side, Side];
}

const GROUNDS: Readonly<Record<Background, { readonly background: string; readonly ink: string }>> = {
  white: { background: "#ffffff", ink: "#000000" },
  transparent: { background: "#ffffff", ink: "#000000" },
  dark: { background: "#14181c", ink: "#ffffff" },
};

/** The legend takes at most this share of the height, or it is cut short. */
const MOST_LEGEND = 0.4;
/** Length of a scale in heights of its text. */
const SCALE_LENGTH = 12;

type Context = OffscreenCanvasRenderingContext2D;

/**
 * The picture as a PNG file, or the same scaled down for a preview. Throws where the browser cannot
 * make one of this size.
 */
export async function compose(view: PointView, subject: Subject, whole: Wish, scale = 1): Promise<Blob> {
  const scaled = (length: number) => Math.max(1, Math.round(scale * length));
  const wish = { ...whole, width: scaled(whole.width), height: scaled(whole.height) };
  const { width, height, background, legend } = wish;
  const canvas = new OffscreenCanvas(width, height);
  const context = canvas.getContext("2d");
  if (!context) throw new Error("The browser could not make a picture of this size.");
  const text = scale * Math.max(11, Math.sqrt(whole.width * whole.height) / 60);
  context.font = `${text}px system-ui, sans-serif`;
  context.textBaseline = "middle";

  const rows = legend ? rowsOf(context, subject, text, wish) : [];
  const line = Math.round(1.7 * text);
  const below = rows.length > 0 ? rows.length * line + Math.round(0.6 * text) : 0;
  const ground = GROUNDS[background];
  const pixels = view.pixels({ width, height: height - below, transparent: background === "transparent", ...ground });
  context.putImageData(pixels, 0, 0);
  if (background !== "transparent") {
    context.fillStyle = ground.background;
    context.fillRect(0, height - below, width, below);
  }
  if (legend) nameViews(context, view, subject, text, { width, height: height - below }, ground.ink);
  rows.forEach((row, at) => drawRow(context, row, text, height - below + Math.round((at + 0.5) * line), ground.ink));
  return canvas.convertToBlob({ type: "image/png" });
}

type Item = KeyEntry | { readonly scaleTo: string } | { readonly note: string };
interface Placed {
  readonly item: Item;
  readonly left: number;
}

function itemsOf({ mode, scene, sides, reports }: Subject): Item[] {
  if (mode === "distance") return [{ scaleTo: endOfScale(scene) }];
  const primitives = mode === "segments" ? primitiveKey(sides, { scene, reports }) : mode === "figure" ? primitiveKey(["truth"], { scene, reports }) : [];
  return [...primitives, ...fixedKey(mode)];
}

/** The items in rows that fit the width; where they take too much height the last one says how many are left out. */
function rowsOf(context: Context, subject: Subject, text: number, { width, height }: Wish): Placed[][] {
  const items = itemsOf(subject);
  const most = Math.max(1, Math.floor((MOST_LEGEND * height) / (1.7 * text)));
  const rows: Placed[][] = [];
  let left = Infinity;
  for (const [at, item] of items.entries()) {
    const wide = widthOf(context, item, text);
    if (left + wide > width - text) {
      if (rows.length === most) {
        const last = rows.at(-1)?.at(-1);
        rows.at(-1)?.pop();
        rows.at(-1)?.push({ item: { note: `and ${items.length - at + 1} more` }, left: last?.left ?? text });
        break;
      }
      rows.push([]);
      left = text;
    }
    rows.at(-1)?.push({ item, left });
    left += wide + 1.4 * text;
  }
  return rows;
}

function widthOf(context: Context, item: Item, text: number): number {
  const width = (words: string) => context.measureText(words).width;
  if ("note" in item) return width(item.note);
  if ("scaleTo" in item) return width("0") + SCALE_LENGTH * text + text + width(item.scaleTo);
  return 1.3 * text + width(item.text);
}

function drawRow(context: Context, row: readonly Placed[], text: number, middle: number, ink: string): void {
  const write = (words: string, x: number) => {
    context.fillStyle = ink;
    context.fillText(words, x, middle);
  };
  for (const { item, left } of row) {
    if ("note" in item) {
      write(item.note, left);
    } else if ("scaleTo" in item) {
      const start = left + context.measureText("0").width + 0.5 * text;
      const end = start + SCALE_LENGTH * text;
      const gradient = context.createLinearGradient(start, 0, end, 0);
      SEQUENTIAL.forEach((colour, at) => gradient.addColorStop(at / (SEQUENTIAL.length - 1), colour));
      write("0", left);
      context.fillStyle = gradient;
      context.fillRect(start, middle - 0.4 * text, end - start, 0.8 * text);
      write(item.scaleTo, end + 0.5 * text);
    } else {
      context.fillStyle = item.colour;
      context.fillRect(left, middle - 0.45 * text, 0.9 * text, 0.9 * text);
      write(item.text, left + 1.3 * text);
    }
  }
}

/** The model and what each view shows of it, over the views. */
function nameViews(
  context: Context,
  view: PointView,
  { model, scene, sides }: Subject,
  text: number,
  { width, height }: Pick<Wish, "width" | "height">,
  ink: string,
): void {
  const [left, right] = sides.map((side) => `${model}, ${nameOf(side, scene)}`);
  const layout = view.getLayout();
  context.fillStyle = ink;
  const write = (words = "", x: number, y = 0) => context.fillText(words, x, y + 1.2 * text);
  if (layout.kind === "single") {
    write(layout.side === 0 ? left : right, text);
  } else if (layout.kind === "split") {
    write(left, text);
    // Where there is more height than width the views lie one above the other.
    if (width >= height) write(right, width / 2 + text);
    else write(right, text, height / 2);
  } else {
    write(left, text);
    context.textAlign = "right";
    write(right, width - text);
    context.textAlign = "left";
  }
}
