// The measures, as the engine declares them.

import { MEASURES as DECLARED } from "../../generated/declared/measures.js";
import type { AccuracyMeasure, Group, Measure, MeasureInfo } from "../engine/contract";

/** In the order of the paper's tables. */
export const MEASURES: readonly Measure[] = DECLARED.map(({ key }) => key);

export const CLASSIFICATION_MEASURES = ofGroup("classification");
/** Those of predicted surfaces; declared as such, so that a prediction's report has them. */
export const ACCURACY_MEASURES = ofGroup("accuracy") as readonly AccuracyMeasure[];

/** What there is to know of each. */
export const MEASURE = Object.fromEntries(DECLARED.map((info) => [info.key, info])) as Readonly<Record<Measure, MeasureInfo>>;

function ofGroup(wanted: Group): readonly Measure[] {
  return DECLARED.filter(({ group }) => group === wanted).map(({ key }) => key);
}

/** Whether a measure is a share of 1. */
export function isShare(measure: Measure): boolean {
  return MEASURE[measure].most === 1;
}
