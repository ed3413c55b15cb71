// Reports name primitives by number; views and tables go by place.

import type { Report } from "../engine/contract";

const known = new WeakMap<Report, readonly (number | undefined)[]>();

/** Place among the predictions of the match of the true primitive at a place. */
export function placeOfMatch(report: Report, truth: number): number | undefined {
  let matches = known.get(report);
  if (!matches) {
    const places = new Map(report.predictions.map(({ prediction }, place) => [prediction, place]));
    matches = report.primitives.map(({ match }) => (match === null ? undefined : places.get(match)));
    known.set(report, matches);
  }
  return matches[truth];
}
