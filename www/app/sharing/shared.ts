// What a link says: whose results, by which rules, on which files.

import type { FitRequest } from "../../worker/protocol";
import type { Measure, Protocol, SampleOptions } from "../engine/contract";
import type { PublicModel } from "../state/origin";
import type { Side } from "../state/selection";
import type { CameraState } from "../view/types";

/**
 * The first eight bytes of a SHA-256, as sixteen hexadecimal digits. It tells whether the same
 * files are at hand; it vouches for nothing, since figures turn "verified" only by being computed
 * again. 64 bits leave one accidental match in 10¹⁹, and a forged one would gain nothing.
 */
export type Fingerprint = string;

export const FINGERPRINT_BYTES = 8;

/** How the model's scene is had again without the files: made, or fetched by its name. */
export type SharedOrigin =
  | { readonly kind: "files" }
  | { readonly kind: "sample"; readonly part: string; readonly options: SampleOptions }
  /** Links of version 1 do not say which one it is. */
  | { readonly kind: "public"; readonly model?: PublicModel };

export interface SharedModel {
  readonly name: string;
  readonly points: number;
  /** Number of true primitives. */
  readonly truth: number;
  readonly origin: SharedOrigin;
  /** Of the cloud and the ground truth. */
  readonly inputs?: Fingerprint;
}

/** The figures claimed for one submission on one model. */
export interface Claim {
  /** Place of its model among the models. */
  readonly model: number;
  readonly method: string;
  readonly predicted: number;
  readonly typeErrors: number;
  /** Of the submission's files. */
  readonly submission?: Fingerprint;
  /** How it was fitted, where the page did that: the same cloud gives the same submission again. */
  readonly fitted?: FitRequest;
  /** All digits: a claim can be compared bit by bit. Measures that the link's version does not know are absent. */
  readonly mean: Readonly<Partial<Record<Measure, number | null>>>;
}

/** What the sharer was looking at. */
export interface SharedView {
  /** Place of the selected model among the models. */
  readonly model: number;
  readonly method?: string;
  /** The submission in the left view, where it is not the truth that is there. */
  readonly left?: string;
  /** Whether the truth is in the right view. */
  readonly rightIsTruth?: true;
  readonly primitive?: { readonly side: Side; readonly index: number };
  readonly camera?: CameraState;
  readonly colour?: string;
  readonly arrangement?: string;
}

export interface SharedResults {
  /** Version of the engine that made the figures. */
  readonly engine: string;
  readonly protocol: Protocol;
  readonly models: readonly SharedModel[];
  readonly claims: readonly Claim[];
  readonly view?: SharedView;
}
