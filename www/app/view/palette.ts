// The colours of segments and scalars: the one place that the view, the tables and the charts
// take them from. `scripts/palette.mjs` made the values and says how.

import { SURFACE_TYPES } from "../../generated/declared/surface-types.js";
import { SEGMENT_COLOURS, UNSEGMENTED } from "../../shared/palette.mjs";

/** Red, green and blue, 0 to 255. */
export type Rgb = readonly [number, number, number];

export { SEGMENT_COLOURS, UNSEGMENTED };

/** Misclassified points, as in the paper's figures. */
export const MISCLASSIFIED = "#000000";

/** Correctly found, wrongly found and missed points of one primitive. */
export const OUTCOME_COLOURS = { truePositive: "#2f6fc4", falsePositive: "#c31e00", falseNegative: "#f0d269" } as const;

/** From low to high: even steps of lightness from dark blue to pale yellow, readable without red or green. */
export const SEQUENTIAL: readonly string[] = [
  "#000874", "#002c61", "#003b65", "#01496c", "#005773", "#06657a", "#007481", "#068386", "#0b9289",
  "#08a28a", "#03b284", "#48bf7c", "#70ca73", "#96d467", "#badd5c", "#dfe451", "#ffea6b",
];

/** Colour of a segment, numbered from 0. The same number always has the same colour; after the last they begin again. */
export function segmentColour(number: number): string {
  const count = SEGMENT_COLOURS.length;
  return SEGMENT_COLOURS[((number % count) + count) % count] ?? UNSEGMENTED;
}

/** Colour of a type of surface, by its name; that of unsegmented points for what is none. */
export function typeColour(name: string | null | undefined): string {
  const type = SURFACE_TYPES.find((candidate) => candidate.name === name);
  return type ? segmentColour(type.colour) : UNSEGMENTED;
}

/** The channels of `#rrggbb`. */
export function rgb(hex: string): Rgb {
  const value = Number.parseInt(hex.slice(1), 16);
  return [(value >> 16) & 255, (value >> 8) & 255, value & 255];
}

/** Colours as bytes r g b r g b …, as the view takes them. */
export function bytes(colours: Iterable<string>): Uint8Array {
  return Uint8Array.from([...colours].flatMap(rgb));
}

/** Label 0 unsegmented, label n the n-th segment (counted from 1). */
export function segmentTable(count: number): Uint8Array {
  return bytes([UNSEGMENTED, ...Array.from({ length: count }, (_, number) => segmentColour(number))]);
}

/** Colour of a share (0 to 1) of a map, as CSS; for legends and charts. */
export function sample(map: readonly string[], share: number): string {
  const place = Math.min(Math.max(share, 0), 1) * (map.length - 1);
  const [low, high] = [rgb(map[Math.floor(place)] ?? UNSEGMENTED), rgb(map[Math.ceil(place)] ?? UNSEGMENTED)];
  const mixed = low.map((channel, index) => Math.round(channel + ((high[index] ?? 0) - channel) * (place % 1)));
  return `rgb(${mixed.join(" ")})`;
}
