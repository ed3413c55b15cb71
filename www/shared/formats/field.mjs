// @ts-check
// What the field reports, as tables and as JSON: per model and method, over models, against each
// other, by strata of primitives, and segment by segment as SHREC 2022 has it. Every figure is the engine's.

import { NORMALISATIONS } from "../../generated/declared/normalisations.js";
import { FIGURES } from "../../generated/declared/figures.js";
import { RECOGNITION } from "../../generated/declared/recognition.js";
import { oneLine } from "../text.mjs";
import { BY, comparisonsOf, infoOf, ranksOf, recognitionOf, spreadsByCondition, spreadsOf, strataOf } from "./field-sums.mjs";
import { SHEET_FORMATS } from "./sheet.mjs";

/**
 * @typedef {import("../../generated/engine/engine.js").FigureInfo} FigureInfo
 * @typedef {import("../../generated/engine/engine.js").FigureScale} FigureScale
 * @typedef {import("../../generated/engine/engine.js").FigureSpread} FigureSpread
 * @typedef {import("./field-sums.mjs").By} By
 * @typedef {import("./field-sums.mjs").Reported & { engine: string, files: import("./results.mjs").HashedFile[] }} FieldResult
 * @typedef {object} Asked
 * @property {readonly FigureInfo[]} figures
 * @property {FigureScale} scale
 * @property {readonly By[]} by strata
 * @property {boolean} segments whether SHREC 2022's tables of segments
 * @typedef {import("./sheet.mjs").Sheet} Sheet
 * @typedef {import("./field-sums.mjs").Counting} Counting
 */

/**
 * Head of a figure's column, with its unit and, of lengths, what they are divided by.
 * @param {FigureInfo} figure
 * @param {FigureScale} scale
 */
export function headOf({ title, unit, isNormalised, better }, { normalisation, epsilon }) {
  const length = unitOf(normalisation);
  // Of what is better the higher, a coverage, ε is the length.
  const of = !isNormalised ? unit : better === "lower" ? length : `ε = ${epsilon} ${length}`;
  return of === "" ? title : `${title} (${of})`;
}

/**
 * What a length is given in, in words.
 * @param {string} normalisation
 */
export function unitOf(normalisation) {
  return NORMALISATIONS.find(({ name }) => name === normalisation)?.unit ?? normalisation;
}

/** What stands below the rows of single models. @type {readonly (readonly [string, (spread: FigureSpread) => number | null])[]} */
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
export function fieldSheets(engine, results, { figures, scale, by, segments }) {
  if (results.length === 0) {
    return { sheets: [], notes: [] };
  }
  const spreads = spreadsOf(engine, results, figures);
  const sheets = [
    ...(figures.length > 0 ? [figuresSheet(results, spreads, figures, scale), ...placesSheet(spreads, figures), ...pairsSheet(engine, results, figures)] : []),
    ...by.flatMap((each) => strataSheets(engine, results, each, { figures, scale })),
    ...(segments ? [undefined, ...by].flatMap((each) => segmentSheets(engine, results, scale, each)) : []),
  ];
  return { sheets, notes: [...notesOf(results, scale), ...by.map((each) => `${infoOf(each).title}: ${infoOf(each).how}`), ...filesOf(results)] };
}

/**
 * Every model and method, then each method over its models.
 * @param {readonly FieldResult[]} results
 * @param {ReturnType<typeof spreadsOf>} spreads
 * @param {readonly FigureInfo[]} figures
 * @param {FigureScale} scale
 * @returns {Sheet}
 */
function figuresSheet(results, spreads, figures, scale) {
  const single = results.map((result) => ({
    labels: [result.model, result.method],
    values: figures.map(({ key }) => result.figures[key]),
  }));
  const summary = spreads
    .filter(({ models }) => models > 1)
    .flatMap(({ method, models, figures: own }) =>
      SUMMARY.map(([name, of]) => ({
        labels: [name === "mean" ? `mean of ${models}` : name, method],
        values: own.map(({ spread }) => (spread ? of(spread) : null)),
      })),
    );
  return { caption: "figures", heads: ["model", "method"], columns: columnsOf(figures, scale), rows: [...single, ...summary] };
}

/**
 * @param {readonly FigureInfo[]} figures
 * @param {FigureScale} scale
 */
function columnsOf(figures, scale) {
  return figures.map((figure) => ({ title: headOf(figure, scale), decimals: figure.decimals }));
}

/**
 * The place of each method by each protocol, and by how much it is another than by the first.
 * @param {ReturnType<typeof spreadsOf>} spreads
 * @param {readonly FigureInfo[]} figures
 * @returns {Sheet[]}
 */
function placesSheet(spreads, figures) {
  const protocols = figures.filter(({ group }) => group === "segmentation");
  if (spreads.length < 2 || protocols.length < 2) {
    return [];
  }
  const ranks = protocols.map((figure) => ranksOf(spreads, figure));
  return [
    {
      caption: "places of the methods, by the mean over their models; moved against the first protocol",
      heads: ["method", ...protocols.map(({ title }) => title)],
      columns: [],
      rows: spreads.map(({ method }) => ({ labels: [method, ...ranks.map((rank) => placeText(rank.get(method), ranks[0]?.get(method)))], values: [] })),
    },
  ];
}

/**
 * @param {number | undefined} place
 * @param {number | undefined} first the place by the first protocol
 */
function placeText(place, first) {
  if (place === undefined || first === undefined || place === first) {
    return place === undefined ? "n/a" : String(place);
  }
  return place < first ? `${place} (up ${first - place})` : `${place} (down ${place - first})`;
}

/**
 * @param {Counting} engine
 * @param {readonly FieldResult[]} results
 * @param {readonly FigureInfo[]} figures
 * @returns {Sheet[]}
 */
function pairsSheet(engine, results, figures) {
  const pairs = comparisonsOf(engine, results, figures).filter(({ better, even, worse }) => better + even + worse > 1);
  if (pairs.length === 0) {
    return [];
  }
  const whole = ["wins", "ties", "losses"].map((title) => ({ title, decimals: 0 }));
  return [
    {
      caption: "methods against each other, model by model",
      heads: ["figure", "method", "against"],
      columns: [{ title: "mean difference", decimals: 5 }, ...whole, { title: "p (Wilcoxon)", decimals: 4 }],
      rows: pairs.map(({ title, method, against, mean, better, even, worse, test }) => ({
        labels: [title, method, against],
        values: [mean?.by ?? null, better, even, worse, test?.probability ?? null],
      })),
    },
  ];
}

/**
 * True primitives by stratum; of what is a condition of models also the figures of these.
 * @param {Counting} engine
 * @param {readonly FieldResult[]} results
 * @param {By} by
 * @param {Pick<Asked, "figures" | "scale">} asked
 * @returns {Sheet[]}
 */
function strataSheets(engine, results, by, { figures, scale }) {
  const counts = ["models", "primitives"].map((title) => ({ title, decimals: 0 }));
  const shares = ["mean IoU", "95 % from", "95 % to", "lower quartile", "median IoU", "upper quartile", "share with IoU > 0.5"];
  const conditioned = spreadsByCondition(engine, results, by, figures);
  return [
    {
      caption: `true primitives by ${by}`,
      heads: [by, "method"],
      columns: [...counts, ...shares.map((title) => ({ title, decimals: 4 }))],
      rows: strataOf(engine, results, by).map(({ method, stratum, models, primitives, iou, found }) => ({
        labels: [stratum, method],
        values: [
          ...[models, primitives, iou?.mean ?? null, iou?.interval?.[0] ?? null, iou?.interval?.[1] ?? null],
          ...[iou?.lowerQuartile ?? null, iou?.median ?? null, iou?.upperQuartile ?? null, found],
        ],
      })),
    },
    ...(conditioned.length > 0
      ? [
          {
            caption: `figures by ${by}, mean over models`,
            heads: [by, "method"],
            columns: [{ title: "models", decimals: 0 }, ...columnsOf(figures, scale)],
            rows: conditioned.map(({ stratum, method, models, figures: own }) => ({
              labels: [stratum, method],
              values: [models, ...own.map(({ spread }) => spread?.mean ?? null)],
            })),
          },
        ]
      : []),
  ];
}

/** The rates of SHREC 2022, in the order of its tables. */
export const RATES = /** @type {const} */ (["PPV", "NPV", "TPR", "TNR", "ACC"]);

/** What stands in SHREC 2022's tables of a fit. @type {readonly (readonly [string, (spread: FigureSpread) => number])[]} */
const FITTED = [
  ["mean", ({ mean }) => mean],
  ["lower quartile", ({ lowerQuartile }) => lowerQuartile],
  ["median", ({ median }) => median],
  ["upper quartile", ({ upperQuartile }) => upperQuartile],
];

/**
 * The heads of what is measured of a fit, with their units.
 * @param {FigureScale} scale
 */
export function fittedHeads({ normalisation }) {
  const length = unitOf(normalisation);
  return /** @type {const} */ ([
    ["mfe", `MFE (${length})`],
    ["hausdorff", `directed Hausdorff (${length})`],
    ["parameters", "L2 of parameters (mixed units)"],
  ]);
}

/**
 * SHREC 2022's tables, of all segments or by stratum.
 * @param {Counting} engine
 * @param {readonly FieldResult[]} results
 * @param {FigureScale} scale
 * @param {By} [by]
 * @returns {Sheet[]}
 */
function segmentSheets(engine, results, scale, by) {
  const rows = recognitionOf(engine, results, by);
  const of = by ? `segments by ${by}` : "segments";
  const heads = [by ?? "segments", "method"];
  const count = { title: "count", decimals: 0 };
  const measured = fittedHeads(scale);
  return [
    {
      caption: `${RECOGNITION.title}, types of ${of}: mean over types`,
      heads,
      columns: [count, ...RATES.map((title) => ({ title, decimals: 4 }))],
      rows: rows.map(({ stratum, method, segments, rates }) => ({
        labels: [stratum, method],
        values: [segments, ...RATES.map((rate) => rates[rate])],
      })),
    },
    {
      caption: `${RECOGNITION.title}, fit of ${of}`,
      heads: [...heads, "measure"],
      columns: [count, ...FITTED.map(([title]) => ({ title, decimals: 2, scientific: true }))],
      rows: rows.flatMap((row) =>
        measured.map(([key, head]) => ({
          labels: [row.stratum, row.method, head],
          values: [row[key]?.count ?? 0, ...FITTED.map(([, value]) => (row[key] ? value(row[key]) : null))],
        })),
      ),
    },
  ];
}

/**
 * How the figures came about.
 * @param {readonly FieldResult[]} results
 * @param {FigureScale} scale
 */
function notesOf(results, { normalisation, epsilon }) {
  const versions = [...new Set(results.map(({ engine }) => engine))];
  return versions.map((version) => `Fit4CAD engine ${oneLine(version)}, lengths normalised by ${normalisation}, epsilon ${epsilon}`);
}

/**
 * The files, as `sha256sum` lists them.
 * @param {readonly FieldResult[]} results
 */
function filesOf(results) {
  const files = results.flatMap((result) => result.files);
  return [...new Set(files.map(({ path, sha256 }) => `${sha256 ?? "(not hashed)"}  ${oneLine(path)}`))];
}

/**
 * JSON: every figure with protocol, normalisation and engine version.
 * @param {Counting} engine
 * @param {readonly FieldResult[]} results
 * @param {Asked} asked
 */
export function fieldJson(engine, results, { figures, scale, by, segments }) {
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
  const spreads = spreadsOf(engine, results, figures);
  const ranks = new Map(figures.map((figure) => [figure.key, ranksOf(spreads, figure)]));
  /** @param {ReturnType<typeof spreadsOf>[number]["figures"]} own */
  const told = (own) => own.map(({ figure, spread }) => ({ ...ways.get(figure), ...spread }));
  const matched = { protocol: "one-to-one matching by IoU", normalisation: null, engine: version };
  const recognised = { protocol: RECOGNITION.title, normalisation: scale.normalisation, engine: version };
  return `${JSON.stringify(
    {
      engine: version,
      scale,
      results: results.map(({ figures: values, scale: _, ...result }) => ({
        ...result,
        figures: figures.map((figure) => ({ ...way(figure), value: values[figure.key] })),
      })),
      summaries: spreads.map(({ figures: own, ...summary }) => ({
        ...summary,
        figures: told(own).map((figure, at) => ({ ...figure, place: ranks.get(own[at]?.figure ?? "fit4cad")?.get(summary.method) ?? null })),
      })),
      comparisons: comparisonsOf(engine, results, figures).map((pair) => ({ ...ways.get(pair.figure), ...pair })),
      strata: by.map((each) => ({
        by: each,
        how: infoOf(each).how,
        rows: strataOf(engine, results, each).map((row) => ({ figure: "iou", ...matched, ...row })),
        figures: spreadsByCondition(engine, results, each, figures).map(({ figures: own, ...row }) => ({ ...row, figures: told(own) })),
      })),
      ...(segments
        ? {
            recognition: [undefined, ...by].map((each) => ({
              by: each ?? null,
              rows: recognitionOf(engine, results, each).map((row) => ({ ...recognised, ...row })),
            })),
          }
        : {}),
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
  const asked = { figures: FIGURES, scale, by: BY, segments: true };
  const write = Object.entries(BY_EXTENSION).find(([each]) => each === extension)?.[1];
  return write ? write(fieldSheets(engine, results, asked)) : fieldJson(engine, results, asked);
}
