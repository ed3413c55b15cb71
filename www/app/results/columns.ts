// What the table can show of each method: the measures by one of the paper's protocols, or what the field reports.

import { FIGURES } from "../../generated/declared/figures.js";
import { FIGURE_SCALE } from "../../generated/declared/figure-scale.js";
import { PROTOCOLS } from "../../generated/declared/protocols.js";
import type { Entry, Figures } from "../../shared/results/scores.mjs";
import { headOf, written } from "../field/figures";
import type { FigureSpread, Protocol } from "../engine/contract";
import { MEASURE, MEASURES } from "../measures/measures";
import * as format from "../ui/format";

/** One figure, however it came about. */
export interface Figure {
  readonly key: string;
  readonly title: string;
  /** What it means, in a sentence. */
  readonly meaning: string;
  readonly better: "higher" | "lower";
  readonly write: (value: number | null | undefined) => string;
  readonly of: <V>(figures: Figures<V>) => V | undefined;
}

export interface View {
  readonly name: string;
  readonly title: string;
  readonly meaning: string;
  readonly figures: readonly Figure[];
}

function measuresBy(protocol: Protocol): Figure[] {
  return MEASURES.map((measure) => ({
    key: measure,
    title: measure,
    meaning: MEASURE[measure].meaning,
    better: MEASURE[measure].better,
    write: (value) => format.measure(measure, value),
    of: (figures) => figures[protocol][measure],
  }));
}

function ofField(group: "segmentation" | "fit"): Figure[] {
  return FIGURES.filter((figure) => figure.group === group).map((figure) => ({
    key: figure.key,
    title: headOf(figure, FIGURE_SCALE),
    meaning: figure.definition,
    better: figure.better,
    write: (value) => written(figure, value),
    of: (figures) => figures.figures[figure.key],
  }));
}

const FIELD = {
  protocols: { title: "Protocols of the field", meaning: "The segmentation by the evaluation code of other benchmarks.", figures: ofField("segmentation") },
  fit: { title: "Figures of fit", meaning: "True and predicted primitives matched one to one; lengths in the unit named.", figures: ofField("fit") },
};

export type ViewName = Protocol | keyof typeof FIELD | "wear";

export const VIEWS: readonly (View & { readonly name: ViewName })[] = [
  ...PROTOCOLS.map(({ name, meaning }) => ({ name, title: format.capitalised(name), meaning, figures: measuresBy(name) })),
  ...Object.entries(FIELD).map(([name, view]) => ({ name: name as keyof typeof FIELD, ...view })),
  { name: "wear", title: "Clean and degraded", meaning: "One figure on a set as it is and on worse scans of it, which everyone can make by their seed.", figures: [] },
];

/** Every figure that can be set against time, or be followed from clean to degraded data: those by the paper's definitions first. */
export const ALL_FIGURES: readonly Figure[] = [...measuresBy("definition"), ...FIELD.protocols.figures];

/** The mean, where there is one. */
export function meanOf(figure: Figure, summary: Figures<FigureSpread | null> | undefined): FigureSpread | undefined {
  return (summary && figure.of(summary)) ?? undefined;
}

export function valueOf(figure: Figure, entry: Entry): number | null {
  return figure.of(entry) ?? null;
}

/** Which of two means is first: the better; one that is missing comes last. */
export function inOrder({ better }: Pick<Figure, "better">, one: number | undefined, other: number | undefined): number {
  if (one === undefined || other === undefined) return Number(one === undefined) - Number(other === undefined);
  return better === "higher" ? other - one : one - other;
}

/** Of values of one figure, how far each is from the worst to the best, 0 to 1; for shading alone. */
export function heatOf({ better }: Pick<Figure, "better">, values: readonly (number | undefined)[]): (value: number | undefined) => number {
  const known = values.filter((value) => value !== undefined);
  const [least, most] = [Math.min(...known), Math.max(...known)];
  return (value) => (value === undefined || most === least ? 0 : better === "higher" ? (value - least) / (most - least) : (most - value) / (most - least));
}

/** Whether a value is the best of its figure, as far as the digits shown tell, where there are several. */
export function isBest({ better, write }: Figure, value: number | undefined, values: readonly (number | undefined)[]): boolean {
  const known = values.filter((each) => each !== undefined);
  if (value === undefined || known.length < 2) return false;
  const best = better === "higher" ? Math.max(...known) : Math.min(...known);
  return write(value) === write(best);
}
