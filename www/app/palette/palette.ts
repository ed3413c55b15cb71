// One colour per primitive, the same in views, tables and charts.
//
// The hues go round in steps of the golden angle, so that neighbours in the list differ, and three
// lightness levels take turns, so that they also differ for readers who do not see the hue. Levels
// stay in the middle: every colour stands out from a white page and from a black one.

export type Rgb = readonly [red: number, green: number, blue: number];

const GOLDEN_ANGLE = 137.50776;
const FIRST_HUE = 250;
const LEVELS: readonly { lightness: number; chroma: number }[] = [
  { lightness: 0.62, chroma: 0.15 },
  { lightness: 0.76, chroma: 0.13 },
  { lightness: 0.5, chroma: 0.14 },
];

const known: Rgb[] = [];

/** The colour of the primitive at a place of the ground truth. */
export function primitiveColour(index: number): Rgb {
  for (let i = known.length; i <= index; i++) {
    const { lightness, chroma } = LEVELS[i % LEVELS.length] ?? { lightness: 0.62, chroma: 0.15 };
    known.push(oklch(lightness, chroma, FIRST_HUE + i * GOLDEN_ANGLE));
  }
  return known[index] ?? UNSEGMENTED;
}

/** Points that belong to no primitive. */
export const UNSEGMENTED: Rgb = [140, 145, 152];

export function css([red, green, blue]: Rgb): string {
  return `rgb(${red} ${green} ${blue})`;
}

/** OKLCH (Ottosson 2020) to sRGB; the chroma gives way where the screen cannot show it. */
function oklch(lightness: number, chroma: number, hue: number): Rgb {
  const angle = (hue * Math.PI) / 180;
  for (let c = chroma; ; c -= 0.01) {
    const rgb = oklab(lightness, c * Math.cos(angle), c * Math.sin(angle));
    if (c <= 0 || rgb.every((channel) => channel >= 0 && channel <= 1)) {
      const [red, green, blue] = rgb.map((channel) => Math.round(255 * Math.min(1, Math.max(0, channel))));
      return [red ?? 0, green ?? 0, blue ?? 0];
    }
  }
}

function oklab(lightness: number, a: number, b: number): number[] {
  const l = (lightness + 0.3963377774 * a + 0.2158037573 * b) ** 3;
  const m = (lightness - 0.1055613458 * a - 0.0638541728 * b) ** 3;
  const s = (lightness - 0.0894841775 * a - 1.291485548 * b) ** 3;
  return [
    4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
    -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
    -0.0041960863 * l - 0.7034186147 * m + 1.707614701 * s,
  ].map((linear) => (linear <= 0.0031308 ? 12.92 * linear : 1.055 * linear ** (1 / 2.4) - 0.055));
}
