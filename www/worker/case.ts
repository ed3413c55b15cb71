// A case: a part or a model, how it is sampled, and what is cut out of it. Plain data, so that it
// can be undone, kept and sent.

import type { ModelSource } from "./protocol";

export type Vector = readonly [number, number, number];

/** A shape in its place; see the engine's `Block`. */
export interface Block {
  readonly operation: "add" | "cut";
  readonly shape: string;
  readonly sizes: readonly number[];
  readonly position: Vector;
  /** Degrees about x, then y, then z. */
  readonly rotation: Vector;
}

/** What the points are taken from. */
export type Base =
  | { readonly kind: "blocks"; readonly blocks: readonly Block[] }
  | { readonly kind: "sample"; readonly part: string }
  /** Files of the reader's: points and truth as they are. */
  | { readonly kind: "files"; readonly source: ModelSource };

/** Lengths are shares of the diagonal. */
export interface Sampling {
  /** Distance of neighbours; without meaning where the points are given. */
  readonly spacing: number;
  readonly noise: number;
  readonly outliers: number;
  readonly seed: number;
}

export interface Ball {
  readonly kind: "ball";
  readonly centre: Vector;
  readonly radius: number;
}

/** A polygon in the plane through a camera's target, swept along its lines of sight. */
export interface Lasso {
  readonly kind: "lasso";
  readonly target: Vector;
  /** Unit quaternion x y z w. */
  readonly rotation: readonly [number, number, number, number];
  /** Distance of the eye from the target; infinite where lines of sight are parallel. */
  readonly eye: number;
  /** How far beyond the target it reaches; may be infinite. */
  readonly depth: number;
  readonly corners: readonly (readonly [number, number])[];
}

export type Cut = Ball | Lasso;

export interface Case {
  readonly name: string;
  readonly base: Base;
  readonly sampling: Sampling;
  /** In the order in which they were made. They take points of the finished cloud, outliers too. */
  readonly cuts: readonly Cut[];
}
