// Reports name primitives by number; views and tables go by place.

import type { Report } from "../engine/contract";

interface Matches {
  /** By true primitive, the prediction it is matched with. */
  readonly predictions: readonly (number | undefined)[];
  /** By prediction, the first true primitive that is matched with it. */
  readonly truths: ReadonlyMap<number, number>;
}

const known = new WeakMap<Report, Matches>();

function matchesOf(report: Report): Matches {
  let matches = known.get(report);
  if (!matches) {
    const places = new Map(report.predictions.map(({ prediction }, place) => [prediction, place]));
    const predictions = report.primitives.map(({ match }) => (match === null ? undefined : places.get(match)));
    const truths = new Map<number, number>();
    predictions.forEach((prediction, truth) => {
      if (prediction !== undefined && !truths.has(prediction)) truths.set(prediction, truth);
    });
    matches = { predictions, truths };
    known.set(report, matches);
  }
  return matches;
}

/** Place among the predictions of the match of the true primitive at a place. */
export function placeOfMatch(report: Report, truth: number): number | undefined {
  return matchesOf(report).predictions[truth];
}

/** Place of the first true primitive that is matched with the prediction at a place. */
export function truthOfMatch(report: Report | undefined, prediction: number): number | undefined {
  return report && matchesOf(report).truths.get(prediction);
}
