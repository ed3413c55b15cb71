// @ts-check
// What a reader may want of a table of results: which rows and columns, how many digits, what stands out.

import { MEASURES } from "./measures.mjs";

/** @typedef {import("./measures.mjs").Measure} Measure */

/**
 * @typedef {object} Wanted
 * @property {boolean} means the methods' means alone, without the rows of single models
 * @property {readonly Measure[]} measures the columns
 * @property {number} [digits] after the point; where nothing is said each format has its own number
 * @property {boolean} bold whether the best of several values is bold
 */

/** The most digits after the point: as many as tell any two figures of a submission apart. */
export const MOST_DIGITS = 12;

/** All there is. @type {Wanted} */
export const USUAL = { means: false, measures: MEASURES, bold: false };
