// @ts-check
// What page and command line share of STEP, which a wasm module of its own reads and writes.

import { SURFACE_TYPES } from "../generated/declared/surface-types.js";
import { EXPORT_COLOURS } from "./palette.mjs";

/** What STEP files are called, packed by gzip or not. */
export const STEP_ENDINGS = /** @type {const} */ (["step", "stp", "p21"]);

const STEP_FILE = new RegExp(`\\.(?:${STEP_ENDINGS.join("|")})(?:\\.gz)?$`, "i");

/**
 * Whether a file is called as STEP files are.
 * @param {string} path
 */
export function isStep(path) {
  return STEP_FILE.test(path);
}

/**
 * The name of a STEP file without folders and endings: that of its model.
 * @param {string} path
 */
export function nameOfPart(path) {
  return (path.split(/[/\\]/).at(-1) ?? "").replace(STEP_FILE, "");
}

/** STEP as a form to export in, beside those that the engine declares. */
export const STEP_FORM = {
  name: "step",
  ending: "_surfaces.step",
  title: "Surfaces, STEP",
  meaning: "For CAD (AP214, millimetres): each a face trimmed by the outline of its points, named and coloured.",
};

/** Red, green and blue of each type of surface. The first of the colours is that of points of no segment. */
export const TYPE_COLOURS = Uint8Array.from(SURFACE_TYPES.flatMap(({ colour }) => [...EXPORT_COLOURS.slice(3 * colour + 3, 3 * colour + 6)]));

/**
 * What of a segmentation is not in its STEP file, as a clause.
 * @param {number} leftOut
 */
export function absence(leftOut) {
  return `${leftOut} primitives are not in it: they have no surface, or too few points for an outline`;
}

/** What STEP files are called, in words. */
export const CALLED = STEP_ENDINGS.map((ending) => `.${ending}`).join(", ");
