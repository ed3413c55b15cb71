// What a row on the page stands on: where its ground truth and its submission came from.

import type { SampleOptions } from "../engine/contract";
import type { PublicModel } from "../state/origin";
import type { FitRequest } from "../../worker/protocol";

export type TruthBasis =
  /** The reader dropped, chose or pasted them. */
  | { readonly kind: "files" }
  /** The page downloaded them from the public repository itself. */
  | { readonly kind: "public"; readonly model: PublicModel }
  /** The page's address named them (`?data=`, `?source=`): whoever made the address chose them. */
  | { readonly kind: "address"; readonly address: string }
  | { readonly kind: "sample"; readonly part: string; readonly options: SampleOptions }
  /** Made in the case studio, which links can fill, too. */
  | { readonly kind: "case" }
  /** The page does not know how they came here. */
  | { readonly kind: "unknown" };

export type SubmissionBasis =
  | Extract<TruthBasis, { readonly kind: "files" | "public" | "address" | "unknown" }>
  /** The imperfect submission that comes with a sample. */
  | { readonly kind: "imperfect" }
  | { readonly kind: "fit"; readonly request: FitRequest };

export interface Basis {
  readonly truth: TruthBasis;
  readonly submission: SubmissionBasis;
  /** Whether the submission's list of points says what the ground truth's file says. */
  readonly copiesTruth: boolean;
}

/**
 * Whether everything is the reader's own or the public's. Of anything else the figures may be right,
 * but the link, or its address, chose what they are figures of.
 */
export function isIndependent({ truth, submission }: Basis): boolean {
  return [truth, submission].every(({ kind }) => kind === "files" || kind === "public");
}

/** What was scored, in words: `PG (seed 5, smallest 12) on the sample bracket`. */
export function wordsOf({ truth, submission }: Basis): string {
  // One word for both where both came the same way.
  if (submission.kind === "files" && truth.kind === "files") return "your files";
  if (submission.kind === "address" && truth.kind === "address" && submission.address === truth.address) return fromAddress(truth.address);
  if (submission.kind === "imperfect") return `${truthWords(truth)} with its imperfect submission`;
  return `${submissionWords(submission)} on ${truthWords(truth)}`;
}

const UNKNOWN = "files of unknown origin";

function truthWords(truth: TruthBasis): string {
  switch (truth.kind) {
    case "files":
      return "your ground truth";
    case "public":
      return `public ${truth.model.set} model PC${truth.model.number}`;
    case "address":
      return fromAddress(truth.address);
    case "sample":
      return `the sample ${truth.part}${listed({ ...truth.options })}`;
    case "case":
      return "a case of the studio";
    case "unknown":
      return UNKNOWN;
  }
}

function submissionWords(submission: Exclude<SubmissionBasis, { kind: "imperfect" }>): string {
  switch (submission.kind) {
    case "files":
      return "your submission";
    case "public":
      return "the published result";
    case "address":
      return fromAddress(submission.address);
    case "unknown":
      return UNKNOWN;
    case "fit":
      return `${submission.request.method.toUpperCase()}${listed({ seed: submission.request.seed, ...submission.request.parameters })}`;
  }
}

function fromAddress(address: string): string {
  return `files of ${address}`;
}

/** ` (noise 0.001, seed 9)`; nothing where there is nothing to say. */
function listed(values: Readonly<Record<string, number | undefined>>): string {
  const given = Object.entries(values).filter(([, value]) => value !== undefined);
  return given.length === 0 ? "" : ` (${given.map(([name, value]) => `${name.replaceAll("_", " ")} ${value}`).join(", ")})`;
}
