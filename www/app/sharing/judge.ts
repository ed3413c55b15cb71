// Whether what is on the page bears a claim out.

import { MEASURES } from "../../../bin/formats/measures.mjs";
import type { Measure, Report } from "../engine/contract";
import type { Claim, Fingerprint, SharedModel } from "./shared";

/** A scored submission on the page that a claim may be about. */
export interface Candidate {
  readonly model: string;
  readonly inputs: Fingerprint | undefined;
  readonly submission: Fingerprint | undefined;
  /** By the protocol of the claim. */
  readonly report: Report;
}

export type Figure = Measure | "points" | "truth" | "predicted" | "type errors";

export interface Difference {
  readonly figure: Figure;
  readonly claimed: number | null;
  readonly found: number | null;
}

export type Part = "ground truth" | "submission";

export type Verdict =
  /** Nothing on the page speaks for or against it. */
  | { readonly kind: "claimed" }
  /** The link names no files, so that no files can bear it out. */
  | { readonly kind: "uncheckable" }
  /** A model of that name is here, with other files. */
  | { readonly kind: "other files"; readonly parts: readonly Part[] }
  /** The same files gave other figures. */
  | { readonly kind: "differs"; readonly differences: readonly Difference[] }
  /** The same files gave the same figures, to the last bit. */
  | { readonly kind: "verified" };

export function judge(claim: Claim, model: SharedModel, candidates: readonly Candidate[]): Verdict {
  if (model.inputs === undefined || claim.submission === undefined) return { kind: "uncheckable" };
  // Names are the reader's own affair: the same files under another name are the same files.
  const same = candidates.find(({ inputs, submission }) => inputs === model.inputs && submission === claim.submission);
  if (same) {
    const differences = differencesOf(claim, model, same.report);
    return differences.length === 0 ? { kind: "verified" } : { kind: "differs", differences };
  }
  const namesake = candidates.find(({ model: name, report }) => name === model.name && report.method === claim.method);
  if (!namesake) return { kind: "claimed" };
  const parts: Part[] = [];
  if (namesake.inputs !== model.inputs) parts.push("ground truth");
  if (namesake.submission !== claim.submission) parts.push("submission");
  return { kind: "other files", parts };
}

function differencesOf(claim: Claim, model: SharedModel, report: Report): Difference[] {
  const figures: Difference[] = [
    { figure: "points", claimed: model.points, found: report.points },
    { figure: "truth", claimed: model.truth, found: report.truth },
    { figure: "predicted", claimed: claim.predicted, found: report.predicted },
    ...MEASURES.map((measure) => ({ figure: measure, claimed: claim.mean[measure], found: report.mean[measure] })),
    { figure: "type errors", claimed: claim.typeErrors, found: report.type_errors },
  ];
  return figures.filter(({ claimed, found }) => !Object.is(claimed, found));
}
