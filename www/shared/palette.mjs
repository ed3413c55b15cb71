// Colours of segments, for the page and for what is exported. `scripts/palette.mjs` made the values.

/**
 * The first are the farthest apart: any two of the first 8 differ by at least 0.11 in OKLab, of the first 16 by
 * 0.07, of all by 0.048, to normal eyes and to colour-blind ones alike.
 * @type {readonly string[]}
 */
export const SEGMENT_COLOURS = [
  "#2f6fc4", "#f0d269", "#c31e00", "#69c3ff", "#d28778", "#872d69", "#8787ff", "#a55a78",
  "#b4b400", "#00f0f0", "#2d4ba5", "#ffa5a5", "#879600", "#b478c3", "#a51e3c", "#c36969",
  "#875af0", "#695a96", "#69a5f0", "#d296c3", "#e15a96", "#96c369", "#5a874b", "#b41e87",
  "#d2c32d", "#0096a5", "#1e4bd2", "#00e1c3", "#7878e1", "#b4e196", "#96a53c", "#96780f",
];

/** Points that no segment lists. */
export const UNSEGMENTED = "#8b9097";

/** Red, green and blue of points of no segment, then of the segments: what the engine exports with. */
export const EXPORT_COLOURS = Uint8Array.from(
  [UNSEGMENTED, ...SEGMENT_COLOURS].flatMap((hex) => [1, 3, 5].map((at) => Number.parseInt(hex.slice(at, at + 2), 16))),
);
