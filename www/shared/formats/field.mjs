// @ts-check
// What the field reports, as tables and as JSON: per model and method, over models, against each
// other, and by strata of primitives. Every figure is the engine's.

import { NORMALISATIONS } from "../../generated/declared/normalisations.js";
import { FIGURES } from "../../generated/declared/figures.js";
import { oneLine } from "../text.mjs";
import { STRATA, comparisonsOf, spreadsOf, strataOf } from "./field-sums.mjs";
import { SHEET_FORMATS } from "./sheet.mjs";

/**
 * @typedef {import("../../generated/engine/engine.js").FieldReport} FieldReport
 * @typedef {import("../../generated/engine/engine.js").FigureInfo} FigureInfo
 * @typedef {import("../../generated/engine/engine.js").FigureScale} FigureScale
 * @typedef {FieldReport & { engine: string, files: import("./results.mjs").HashedFile[] }} FieldResult
 * @typedef {{ figures: readonly FigureInfo[], scale: FigureScale, by: readonly Stratum[] }} Asked
 * @typedef {import("./field-sums.mjs").Stratum} Stratum
 * @typedef {import("./field-sums.mjs").Counting} Counting
 */

/**
 * Head of a figure's column, with its unit and, of lengths, what they are divided by.
 * @param {FigureInfo} figure
 * @param {FigureScale} scale
 */
export function headOf({ title, unit, isNormalised, better }, { normalisation, epsilon }) {
  const length = NORMALISATIONS.find(({ name }) => name === normalisation)?.unit ?? normalisation;
  // Of what is better the higher, a coverage, ε is the length.
  const of = !isNormalised ? unit : better === "lower" ? length : `ε = ${epsilon} ${length}`;
  return of === "" ? title : `${title} (${of})`;
}

/** What stands below the rows of single models. @type {readonly (readonly [string, (spread: import("../../generated/engine/engine.js").FigureSpread) => number | null])[]} */
const SUMMARY = [
  ["mean", ({ mean }) => mean],
  ["95 % interval from", ({ interval }) => interval?.[0] ?? null],
  ["95 % interval to", ({ interval }) => interval?.[1] ?? null],
  ["lower quartile", ({ lowerQuartile }) => lowerQuartile],
  ["median", ({ median }) => median],
  ["upper quartile", ({ upperQuartile }) => upperQuartile],
];

/**
 * The tables.
 * @param {Counting} engine
 * @param {readonly FieldResult[]} results
 * @param {Asked} asked
 * @returns {import("./sheet.mjs").Sheets}
 */
export function fieldSheets(engine, results, { figures, scale, by }) {
  if (results.length === 0) {
    return { sheets: [], notes: [] };
  }
  const columns = figures.map((figure) => ({ title: headOf(figure, scale), decimals: figure.decimals }));
  const single = results.map((result) => ({
    labels: [result.model, result.method],
    values: figures.map(({ key }) => result.figures[key]),
  }));
  const several = spreadsOf(engine, results, figures).filter(({ models }) => models > 1);
  const summary = several.flatMap(({ method, models, figures: own }) =>
    SUMMARY.map(([name, of]) => ({
      labels: [name === "mean" ? `mean of ${models}` : name, method],
      values: own.map(({ spread }) => (spread ? of(spread) : null)),
    })),
  );
  const sheets = [{ caption: "figures", heads: ["model", "method"], columns, rows: [...single, ...summary] }];
  const pairs = several.length > 1 ? comparisonsOf(engine, results, figures) : [];
  if (pairs.length > 0) {
    const whole = ["wins", "ties", "losses"].map((title) => ({ title, decimals: 0 }));
    sheets.push({
      caption: "methods against each other, model by model",
      heads: ["figure", "method", "against"],
      columns: [{ title: "mean difference", decimals: 5 }, ...whole, { title: "p (Wilcoxon)", decimals: 4 }],
      rows: pairs.map(({ title, method, against, mean, better, even, worse, test }) => ({
        labels: [title, method, against],
        values: [mean?.by ?? null, better, even, worse, test?.probability ?? null],
      })),
    });
  }
  for (const stratum of by) {
    sheets.push({
      caption: `true primitives by ${stratum}`,
      heads: [stratum, "method"],
      columns: [
        { title: "primitives", decimals: 0 },
        ...["mean IoU", "95 % from", "95 % to", "median IoU", "share with IoU > 0.5"].map((title) => ({ title, decimals: 4 })),
      ],
      rows: strataOf(engine, results, stratum).map(({ method, stratum: name, primitives, iou, found }) => ({
        labels: [name, method],
        values: [primitives, iou?.mean ?? null, iou?.interval?.[0] ?? null, iou?.interval?.[1] ?? null, iou?.median ?? null, found],
      })),
    });
  }
  return { sheets, notes: notesOf(results, scale) };
}

/**
 * Where the figures come from, then the files, as `sha256sum` lists them.
 * @param {readonly FieldResult[]} results
 * @param {FigureScale} scale
 */
function notesOf(results, { normalisation, epsilon }) {
  const versions = [...new Set(results.map(({ engine }) => engine))];
  const ways = versions.map(
    (version) => `Fit4CAD engine ${oneLine(version)}, lengths normalised by ${normalisation}, epsilon ${epsilon}`,
  );
  const files = results.flatMap((result) => result.files);
  return [...ways, ...new Set(files.map(({ path, sha256 }) => `${sha256 ?? "(not hashed)"}  ${oneLine(path)}`))];
}

/**
 * JSON: every figure with protocol, normalisation and engine version.
 * @param {Counting} engine
 * @param {readonly FieldResult[]} results
 * @param {Asked} asked
 */
export function fieldJson(engine, results, { figures, scale, by }) {
  const version = results[0]?.engine ?? "";
  /** @param {FigureInfo} figure */
  const way = ({ key, title, group, isNormalised }) => ({
    figure: key,
    protocol: group === "segmentation" ? title : "SPFN matching",
    normalisation: isNormalised ? scale.normalisation : null,
    ...(isNormalised ? { epsilon: scale.epsilon } : {}),
    engine: version,
  });
  const ways = new Map(figures.map((figure) => [figure.key, way(figure)]));
  return `${JSON.stringify(
    {
      engine: version,
      scale,
      results: results.map(({ figures: values, scale: _, ...result }) => ({
        ...result,
        figures: figures.map((figure) => ({ ...way(figure), value: values[figure.key] })),
      })),
      summaries: spreadsOf(engine, results, figures).map(({ figures: own, ...summary }) => ({
        ...summary,
        figures: own.map(({ figure, spread }) => ({ ...ways.get(figure), ...spread })),
      })),
      comparisons: comparisonsOf(engine, results, figures).map((pair) => ({ ...ways.get(pair.figure), ...pair })),
      strata: by.map((stratum) => ({ by: stratum, rows: strataOf(engine, results, stratum) })),
    },
    null,
    2,
  )}\n`;
}

/** What the extensions of files stand for. */
const BY_EXTENSION = { csv: SHEET_FORMATS.csv, tex: SHEET_FORMATS.latex, md: SHEET_FORMATS.markdown };

/**
 * All figures and strata as a file of an extension: those of the tables' formats, else JSON.
 * @param {Counting} engine
 * @param {readonly FieldResult[]} results
 * @param {FigureScale} scale
 * @param {string} extension
 */
export function fieldText(engine, results, scale, extension) {
  const asked = { figures: FIGURES, scale, by: STRATA };
  const write = Object.entries(BY_EXTENSION).find(([each]) => each === extension)?.[1];
  return write ? write(fieldSheets(engine, results, asked)) : fieldJson(engine, results, asked);
}
