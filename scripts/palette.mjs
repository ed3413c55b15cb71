// Makes the colours of www/shared/palette.mjs and www/app/view/palette.ts. Run it to see how they were chosen; the page uses
// the printed values, so that a colour never changes by accident.
//
// Colours are picked one by one from a grid of the sRGB cube: each is the one farthest from all
// picked before, where the distance of two colours is the least of their OKLab distances
// (Ottosson 2020) as seen with normal vision, protanopia, deuteranopia and tritanopia (Machado,
// Oliveira and Fernandes 2009, severity 1). Greys, near-blacks and near-whites are left out: grey
// means unsegmented, black misclassified, and every colour must show on a light and a dark page.

import { isMain } from "./lib/run.mjs";

/** Three coordinates of a colour. @typedef {[number, number, number]} Triple */

/** Rows of the matrices over linear RGB. @type {Record<string, [Triple, Triple, Triple]>} */
const VISION = {
  normal: [[1, 0, 0], [0, 1, 0], [0, 0, 1]],
  protanopia: [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]],
  deuteranopia: [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.01182, 0.04294, 0.968881]],
  tritanopia: [[1.255528, -0.076749, -0.178779], [-0.078411, 0.930809, 0.147602], [0.004733, 0.691367, 0.3039]],
};
const LIGHTNESS = { least: 0.44, most: 0.87 };
const CHROMA = { least: 0.085, most: 0.215 };
const COUNT = 40;
/** @type {Triple} */
const FIRST = [0x2f, 0x6f, 0xc4];

/** @param {number} byte */
const linear = (byte) => {
  const value = byte / 255;
  return value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;
};

/** @param {number} value */
const encode = (value) => {
  const clamped = Math.min(Math.max(value, 0), 1);
  return Math.round(255 * (clamped <= 0.0031308 ? clamped * 12.92 : 1.055 * clamped ** (1 / 2.4) - 0.055));
};

/**
 * OKLab of linear RGB.
 * @param {Triple} rgb
 * @returns {Triple}
 */
export function oklab([r, g, b]) {
  const l = Math.cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
  const m = Math.cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
  const s = Math.cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
  return [
    0.2104542553 * l + 0.793617785 * m - 0.0040720468 * s,
    1.9779984951 * l - 2.428592205 * m + 0.4505937099 * s,
    0.0259040371 * l + 0.7827717662 * m - 0.808675766 * s,
  ];
}

/**
 * sRGB bytes of an OKLab colour, and whether it lies in the gamut.
 * @param {Triple} lab
 */
function srgb([L, a, b]) {
  const l = (L + 0.3963377774 * a + 0.2158037573 * b) ** 3;
  const m = (L - 0.1055613458 * a - 0.0638541728 * b) ** 3;
  const s = (L - 0.0894841775 * a - 1.291485548 * b) ** 3;
  /** @type {Triple} */
  const channels = [
    4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
    -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
    -0.0041960863 * l - 0.7034186147 * m + 1.707614701 * s,
  ];
  return { bytes: mapped(channels, encode), inside: channels.every((c) => c > -0.0005 && c < 1.0005) };
}

/**
 * The OKLab colours under which a colour appears to each kind of vision.
 * @param {Triple} rgb
 */
export function appearances(rgb) {
  const [r, g, b] = mapped(rgb, linear);
  return Object.values(VISION).map((rows) => oklab(mapped(rows, ([a, c, d]) => Math.min(Math.max(a * r + c * g + d * b, 0), 1))));
}

/**
 * @template From
 * @param {[From, From, From]} three
 * @param {(one: From) => number} map
 * @returns {Triple}
 */
function mapped([a, b, c], map) {
  return [map(a), map(b), map(c)];
}

/**
 * The least distance of two colours over all kinds of vision.
 * @param {readonly Triple[]} one
 * @param {readonly Triple[]} other
 */
export function distance(one, other) {
  return Math.min(...one.map((lab, vision) => Math.hypot(...lab.map((value, axis) => value - (other[vision]?.[axis] ?? NaN)))));
}

/** @param {Triple} rgb */
export const hex = (rgb) => `#${rgb.map((byte) => byte.toString(16).padStart(2, "0")).join("")}`;

/** @typedef {{ rgb: Triple, seen: Triple[], gap: number }} Candidate gap to the nearest that is picked */

function segments() {
  /** @type {Candidate[]} */
  const candidates = [];
  for (let r = 0; r < 256; r += 15) {
    for (let g = 0; g < 256; g += 15) {
      for (let b = 0; b < 256; b += 15) {
        const seen = appearances([r, g, b]);
        const [L, x, y] = oklab(mapped([r, g, b], linear));
        const chroma = Math.hypot(x, y);
        if (L >= LIGHTNESS.least && L <= LIGHTNESS.most && chroma >= CHROMA.least && chroma <= CHROMA.most) {
          candidates.push({ rgb: [r, g, b], seen, gap: Infinity });
        }
      }
    }
  }
  /** @type {Candidate[]} */
  const picked = [];
  let next = { rgb: FIRST, seen: appearances(FIRST), gap: Infinity };
  while (picked.length < COUNT) {
    picked.push({ ...next });
    next = farthest(candidates, next);
  }
  return picked;
}

/**
 * The candidate farthest from all that are picked, of which `last` is new.
 * @param {readonly Candidate[]} candidates
 * @param {Candidate} last
 */
function farthest(candidates, last) {
  for (const candidate of candidates) {
    candidate.gap = Math.min(candidate.gap, distance(candidate.seen, last.seen));
  }
  return candidates.reduce((best, candidate) => (candidate.gap > best.gap ? candidate : best));
}

/**
 * A sequential map: even steps of lightness from dark blue to pale yellow, the two hues that every
 * common colour vision tells apart, through a bend of green grey.
 * @param {number} steps
 */
function sequential(steps) {
  /** @param {number} a @param {number} b @param {number} t */
  const lerp = (a, b, t) => a + (b - a) * t;
  return Array.from({ length: steps }, (_, step) => {
    const t = step / (steps - 1);
    const L = lerp(0.26, 0.93, t);
    const angle = lerp(264, 100, t ** 1.1) * (Math.PI / 180);
    for (let chroma = lerp(0.13, 0.17, Math.abs(2 * t - 1)); ; chroma -= 0.002) {
      const { bytes, inside } = srgb([L, chroma * Math.cos(angle), chroma * Math.sin(angle)]);
      if (inside || chroma <= 0) return bytes;
    }
  });
}

if (isMain(import.meta.url)) {
  for (const { rgb, gap } of segments()) console.log(hex(rgb), gap.toFixed(3));
  console.log(sequential(17).map(hex).join(" "));
}
