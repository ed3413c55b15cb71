// The published methods' figures, scored anew: what a new method is measured against.

import type { Measure, Protocol } from "../engine/contract";
import { PUBLISHED_METHODS, type PublishedMethod } from "../public/catalogue";
import data from "./published.json";

export { PUBLISHED_METHODS, type PublishedMethod };

/** A test model, by what tells it from others of its name. */
export interface TestModel {
  readonly name: string;
  readonly points: number;
  readonly truth: number;
}

type Rows = Readonly<Record<Protocol | "paper", readonly (number | null)[]>>;
type Model = { readonly points: number; readonly truth: number } & Readonly<Record<PublishedMethod, Rows>>;

const MODELS: Readonly<Record<string, Model>> = data.models;
const COLUMNS = data.measures as readonly Measure[];

export const TEST_MODELS: readonly TestModel[] = Object.entries(MODELS).map(([name, { points, truth }]) => ({
  name,
  points,
  truth,
}));

/** A published figure by a protocol, or as the paper prints it; null where there is none. */
export function published(model: string, method: PublishedMethod, by: Protocol | "paper", measure: Measure): number | null {
  return MODELS[model]?.[method][by][COLUMNS.indexOf(measure)] ?? null;
}
