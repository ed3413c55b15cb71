// Observable Plot as the charts use it: colours given outright, clicks that lead somewhere, and a
// drawing that stands on its own as a file.

import * as Plot from "@observablehq/plot";

export { Plot };

/** What a drawing is fitted to. Colours are literal, so that a saved file looks the same anywhere. */
export interface Frame {
  readonly width: number;
  readonly ink: string;
  readonly soft: string;
  readonly line: string;
  readonly surface: string;
  readonly accent: string;
}

/** For files: dark on white, the width of a printed column. */
export const PRINT: Frame = {
  width: 640,
  ink: "#000000",
  soft: "#444444",
  line: "#cccccc",
  surface: "#ffffff",
  accent: "#000000",
};

/** The page's colours as they are now. */
export function frameOf(width: number): Frame {
  const style = getComputedStyle(document.documentElement);
  const token = (name: string) => style.getPropertyValue(name).trim();
  return {
    width,
    ink: token("--ink"),
    soft: token("--ink-soft"),
    line: token("--line"),
    surface: token("--surface"),
    accent: token("--accent"),
  };
}

export function drawn(frame: Frame, options: Plot.PlotOptions): SVGSVGElement {
  const svg = Plot.plot({ color: { type: "identity" }, ...options, width: frame.width, figure: false });
  if (!(svg instanceof SVGSVGElement)) throw new TypeError("a plot without a figure is an SVG element");
  // The page's policy forbids style elements; their two rules are in the style sheet.
  svg.querySelectorAll("style").forEach((style) => style.remove());
  // Plot labels its groups, which have no role that may be labelled; the drawing is named as a whole.
  svg.querySelectorAll("[aria-label], [aria-description]").forEach((part) => {
    part.removeAttribute("aria-label");
    part.removeAttribute("aria-description");
  });
  svg.setAttribute("color", frame.ink);
  return svg;
}

/** A number at a tick, without the digits that binary fractions leave. */
export function tick(value: number): string {
  return String(Number(value.toPrecision(6)));
}

/** Ticks of a logarithmic axis: powers of ten in figures, and what lies between where there are few of them. */
export function decades(low: number, high: number): (value: number) => string {
  const spelt = high / low > 300 ? [1] : high / low > 20 ? [1, 2, 5] : [1, 2, 3, 4, 5, 6, 7, 8, 9];
  return (value) => {
    const exponent = Math.floor(Math.log10(value) + 1e-9);
    if (!spelt.includes(Number((value / 10 ** exponent).toPrecision(6)))) return "";
    return value >= 0.0001 && value < 10_000 ? tick(value) : value.toExponential(0).replace("e-", "e−").replace("e+", "e");
  };
}

type Go = () => void;

const actions = new WeakMap<EventTarget, Go>();

/** More shapes than these in one facet are drawn only where they do not cover each other. */
const CROWD = 2000;
/** Shapes of a crowd are nowhere closer than this, in pixels of the drawing. */
const CLOSEST = 2;

/** Options of a mark whose shapes lead somewhere when clicked, one shape per datum. */
export function leading<T>(data: readonly T[], go: (datum: T) => void): Pick<Plot.MarkOptions, "render"> {
  return {
    render: (index, scales, values, dimensions, context, next) => {
      const shown = index.length > CROWD ? apart(index, values) : index;
      const group = next?.(shown, scales, values, dimensions, context) ?? null;
      [...(group?.children ?? [])].forEach((shape, at) => {
        const datum = data[shown[at] ?? -1];
        if (datum === undefined) return;
        actions.set(shape, () => go(datum));
        shape.classList.add("leads");
      });
      return group;
    },
  };
}

/** Of shapes in the same place, the first: thousands of them would take seconds, and look no different. */
function apart(index: number[], { x, y }: Plot.ChannelValues): number[] {
  const at = (channel: unknown, i: number) => (Array.isArray(channel) || ArrayBuffer.isView(channel) ? (channel as ArrayLike<number>)[i] : 0) ?? 0;
  const taken = new Map(index.toReversed().map((i) => [`${Math.round(at(x, i) / CLOSEST)} ${Math.round(at(y, i) / CLOSEST)}`, i]));
  return [...taken.values()].reverse();
}

/** Follows a click on a shape that leads somewhere. */
export function follow(event: Event): void {
  if (event.target) actions.get(event.target)?.();
}

export interface Key {
  readonly text: string;
  readonly colour: string;
}

const KEY_HEIGHT = 18;
/** Between the keys and the frame: room for a figure on top of a bar. */
const KEY_GAP = 14;
/** Width of a letter, on average, at the size of the keys. */
const LETTER = 6.2;

/** What the colours mean, in rows above the frame; `height` is the room they need. */
export function legend(keys: readonly Key[], frame: Frame, marginLeft: number): { marks: Plot.Markish[]; height: number } {
  let left = 0;
  let row = 0;
  const placed = keys.map((key) => {
    const width = 22 + LETTER * key.text.length;
    if (left > 0 && marginLeft + left + width > frame.width) {
      left = 0;
      row++;
    }
    const place = { ...key, left, row };
    left += width;
    return place;
  });
  const height = KEY_HEIGHT * (row + 1) + KEY_GAP;
  const marks = placed.flatMap(({ text, colour, left, row }) => {
    const dy = KEY_HEIGHT * row + 8 - height;
    const anchor = { frameAnchor: "top-left", dy, facet: "super" } as const;
    return [
      Plot.dot([0], { ...anchor, dx: left + 5, r: 5, symbol: "square", fill: colour, stroke: frame.soft, strokeWidth: 0.75 }),
      Plot.text([text], { ...anchor, dx: left + 14, text: String, textAnchor: "start", lineAnchor: "middle", fontSize: 11 }),
    ];
  });
  return { marks, height };
}
