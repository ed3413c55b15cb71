// What is on the page, as something that may bear out a claim.

import type { Protocol } from "../engine/contract";
import { brought, overrides } from "../state/inbox";
import { fitOf, isMadeHere, madeModels } from "../state/made";
import type { ModelEntry, ScoredRow } from "../state/models";
import type { ModelFile } from "../../worker/protocol";
import type { Basis, SubmissionBasis, TruthBasis } from "./basis";
import type { Evidence } from "./fingerprints";
import type { Candidate } from "./judge";

/** The row as a candidate; may read signals. */
export function candidateOf({ entry, reports }: ScoredRow, evidence: Evidence, protocol: Protocol): Candidate {
  const { inputs, submission, copiesTruth } = evidence;
  return { model: entry.id, inputs, submission, basis: { ...basisOf(entry, reports.method), copiesTruth }, report: reports[protocol] };
}

function basisOf(entry: ModelEntry, method: string): Omit<Basis, "copiesTruth"> {
  const of = (owner: string | undefined) => entry.source.files.filter((file) => file.method === owner);
  return { truth: truthBasis(entry, of(undefined)), submission: submissionBasis(entry, method, of(method)) };
}

function truthBasis({ id, origin }: ModelEntry, files: readonly ModelFile[]): TruthBasis {
  if (origin.kind === "sample") return origin;
  return madeModels.value.has(id) ? { kind: "case" } : broughtBasis(files);
}

function submissionBasis({ id }: ModelEntry, method: string, files: readonly ModelFile[]): SubmissionBasis {
  if (!isMadeHere(id, method)) return broughtBasis(files);
  const request = fitOf(id, method);
  return request ? { kind: "fit", request } : { kind: "imperfect" };
}

/** One file that the page's address named is enough for all to be as good as named by it. */
function broughtBasis(files: readonly ModelFile[]): Extract<TruthBasis & SubmissionBasis, { kind: "files" | "public" | "address" | "unknown" }> {
  const sources = files.map(({ path }) => brought.value.get(path));
  const address = sources.find((source) => source?.named !== undefined)?.named;
  if (address !== undefined) return { kind: "address", address };
  if (sources.length === 0 || sources.includes(undefined)) return { kind: "unknown" };
  const model = sources[0]?.publicModel;
  const isPublic =
    model !== undefined &&
    sources.every((source) => source?.publicModel?.set === model.set && source.publicModel.number === model.number) &&
    files.every(({ path }) => overrides.value[path] === undefined);
  return isPublic ? { kind: "public", model } : { kind: "files" };
}
