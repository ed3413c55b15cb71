// What `fit4cad score` is to show of the benchmark's measures in a table.

import { PROTOCOLS } from "../../www/generated/declared/protocols.js";
import { FORMATS } from "../../www/shared/formats/index.mjs";
import { MEASURES } from "../../www/shared/formats/measures.mjs";
import { MOST_DIGITS } from "../../www/shared/formats/wanted.mjs";
import { UsageError, choice, number } from "./usage.mjs";

/** @typedef {import("../../www/shared/formats/wanted.mjs").Wanted} Wanted */
/** @typedef {{ measures?: string | undefined, means: boolean, digits?: string | undefined, bold: boolean, published: boolean }} Values */

export const TABLE_OPTIONS = /** @type {const} */ ({
  means: { type: "boolean", default: false },
  digits: { type: "string" },
  bold: { type: "boolean", default: false },
  published: { type: "boolean", default: false },
});

/**
 * Whether `--measures` names measures of the benchmark, by its own protocols: columns of its table, no figures of fit.
 * @param {{ protocol: string, by?: string | undefined, measures?: string | undefined }} values
 */
export function areColumns({ protocol, by, measures }) {
  const isOwn = PROTOCOLS.some(({ name }) => name === protocol) && by === undefined;
  return isOwn && measures !== undefined && names(measures).some((name) => MEASURES.some((each) => each === name));
}

/**
 * What is wanted of a table, and whether the published rows are.
 * @param {Values} values
 * @param {keyof typeof FORMATS} format
 * @returns {{ wanted: Wanted, published: boolean }}
 */
export function wantedOf(values, format) {
  const columns = values.measures === undefined ? MEASURES : names(values.measures).map((name) => choice("measures", name, MEASURES));
  const digits = number("digits", values.digits, { least: 0, most: MOST_DIGITS, whole: true });
  const { isTable, hasBold } = /** @type {import("../../www/shared/formats/index.mjs").Format} */ (FORMATS[format]);
  const given = givenOf(values);
  if (!isTable && given.length > 0) {
    throw new UsageError(`${given.join(", ")}: for tables; --format ${format} has everything`);
  }
  if (values.bold && !hasBold) {
    const able = Object.entries(FORMATS).flatMap(([name, each]) => ("hasBold" in each ? [name] : []));
    throw new UsageError(`--bold: for --format ${able.join(" or ")}; ${format} has no bold figures`);
  }
  const measures = MEASURES.filter((measure) => columns.includes(measure));
  return { wanted: { means: values.means, measures, ...(digits === undefined ? {} : { digits }), bold: values.bold }, published: values.published };
}

/**
 * Refuses what is for the benchmark's own table where the field's are asked for.
 * @param {Values} values
 */
export function refuseBesideField(values) {
  const given = givenOf({ ...values, measures: undefined });
  if (given.length > 0) {
    throw new UsageError(`${given.join(", ")}: for the benchmark's own measures, not for other protocols, figures of fit or strata`);
  }
}

/**
 * The options that were given, as they are written.
 * @param {Values} values
 */
function givenOf({ measures, means, digits, bold, published }) {
  const given = { measures: measures !== undefined, means, digits: digits !== undefined, bold, published };
  return Object.entries(given).flatMap(([name, is]) => (is ? [`--${name}`] : []));
}

/** @param {string} list */
function names(list) {
  return list.split(",").map((name) => name.trim());
}
