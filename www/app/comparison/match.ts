// Which test model a model on the page is. A name alone proves nothing: training models, and
// anybody's own, are called PC1 as well.

import type { Report } from "../engine/contract";
import type { ModelEntry } from "../state/models";
import type { TestModel } from "./published";

export interface ModelOnPage {
  readonly name: string;
  readonly points: number;
  readonly truth: number;
}

export type Match =
  /** By name and counts, or because the reader says so. */
  | { readonly kind: "matched"; readonly model: string; readonly said: boolean }
  /** Named like a test model, but not that one. */
  | { readonly kind: "unlike"; readonly model: string; readonly reason: string }
  | { readonly kind: "none" };

/** A model on the page, scored, and what it is. */
export interface Candidate {
  readonly entry: ModelEntry;
  readonly report: Report;
  readonly match: Match;
}

/** What the reader says a model is: the name of a test model, or that it is none. */
export type Said = string | null;

export function matchOf({ name, points, truth }: ModelOnPage, tests: readonly TestModel[], said?: Said): Match {
  if (said === null) return { kind: "none" };
  if (said !== undefined) return { kind: "matched", model: said, said: true };
  // A model's name may hold the folder that tells it from its namesake.
  const own = name.split("/").at(-1)?.toLowerCase();
  const test = tests.find((candidate) => candidate.name.toLowerCase() === own);
  if (!test) return { kind: "none" };
  const differences = [
    points === test.points ? [] : `${points} points for ${test.points}`,
    truth === test.truth ? [] : `${truth} true primitives for ${test.truth}`,
  ].flat();
  if (differences.length === 0) return { kind: "matched", model: test.name, said: false };
  return { kind: "unlike", model: test.name, reason: differences.join(", ") };
}
