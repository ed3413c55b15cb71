// Whether what is on the page bears a claim out, and what exactly it bears out.

import type { Report } from "../engine/contract";
import { isIndependent, type Basis } from "./basis";
import { asLinkText } from "./codec/bytes";
import { compare, type Difference } from "./kinds/figures";
import type { Claim, Fingerprint, SharedModel } from "./shared";

/** A scored submission on the page that a claim may be about. */
export interface Candidate {
  /** What the model is called on the page. */
  readonly model: string;
  readonly inputs: Fingerprint | undefined;
  readonly submission: Fingerprint | undefined;
  readonly basis: Basis;
  /** By the protocol of the claim. */
  readonly report: Report;
}

export type Part = "ground truth" | "submission";

/** What files are called on the page, where the link calls them otherwise. */
export interface Names {
  readonly model?: string;
  readonly method?: string;
}

export type Verdict =
  /** Nothing on the page speaks for or against it. */
  | { readonly kind: "claimed" }
  /** The link names no files, or this page cannot hash files, so that none can bear it out. */
  | { readonly kind: "uncheckable"; readonly where: "link" | "page" }
  /** A model of that name is here, with other files. */
  | { readonly kind: "other files"; readonly parts: readonly Part[] }
  /** The same files gave other figures. */
  | { readonly kind: "differs"; readonly differences: readonly Difference[]; readonly basis: Basis }
  /** The same figures to the last bit, of the very files that an earlier row of the link is about. */
  | { readonly kind: "repeated"; readonly earlier: RowNames; readonly basis: Basis }
  /** The same figures to the last bit, of something that the link itself said how to have. */
  | { readonly kind: "recomputed"; readonly basis: Basis; readonly names: Names }
  /** The same figures to the last bit, of files that are called otherwise here. */
  | { readonly kind: "renamed"; readonly basis: Basis; readonly names: Names }
  /** The same figures to the last bit, but the submission is the ground truth itself. */
  | ({ readonly kind: "copied" } & Own)
  /** The reader's own files, or the public's, of those names gave the same figures, to the last bit. */
  | ({ readonly kind: "verified" } & Own);

interface Own {
  readonly basis: Basis;
  /** The folders by which the page tells the model from others of its name, with the slash. */
  readonly folder?: string;
}

/** What a row of the link is called there. */
export interface RowNames {
  readonly model: string;
  readonly method: string;
}

/** The better first, where several rows on the page are of the same files. */
const RANK = ["verified", "copied", "renamed", "recomputed"] as const;

/** The candidates by their files, and by their names as a link would have them. */
interface Index {
  readonly byFiles: ReadonlyMap<string, readonly Candidate[]>;
  readonly byName: ReadonlyMap<string, readonly Candidate[]>;
}

function filesKey(inputs: Fingerprint | undefined, submission: Fingerprint | undefined): string {
  return `${inputs} ${submission}`;
}

/** Equal for names that differ only in how a system writes accents. */
function nameKey(model: string, method: string): string {
  return JSON.stringify([model, method].map((name) => name.normalize("NFC")));
}

function indexed(candidates: readonly Candidate[]): Index {
  const byFiles = new Map<string, Candidate[]>();
  const byName = new Map<string, Candidate[]>();
  const add = (into: Map<string, Candidate[]>, key: string, candidate: Candidate) => {
    const own = into.get(key);
    if (own) own.push(candidate);
    else into.set(key, [candidate]);
  };
  for (const candidate of candidates) {
    const { inputs, submission, model, report } = candidate;
    if (inputs !== undefined && submission !== undefined) add(byFiles, filesKey(inputs, submission), candidate);
    add(byName, nameKey(asLinkText(model), asLinkText(report.method)), candidate);
  }
  return { byFiles, byName };
}

function judge(claim: Claim, model: SharedModel, { byFiles, byName }: Index): Verdict {
  if (model.inputs === undefined || claim.submission === undefined) return { kind: "uncheckable", where: "link" };
  const same = byFiles.get(filesKey(model.inputs, claim.submission)) ?? [];
  const [first] = same;
  if (first) {
    const differences = compare({ model, claim }, first.report);
    if (differences.length > 0) return { kind: "differs", differences, basis: first.basis };
    const borneOut = same.map((candidate) => bearing(claim, model, candidate));
    return borneOut.reduce((best, next) => (RANK.indexOf(next.kind) < RANK.indexOf(best.kind) ? next : best));
  }
  const [namesake] = byName.get(nameKey(model.name, claim.method)) ?? [];
  if (!namesake) return { kind: "claimed" };
  if (namesake.inputs === undefined || namesake.submission === undefined) return { kind: "uncheckable", where: "page" };
  const parts: Part[] = [];
  if (namesake.inputs !== model.inputs) parts.push("ground truth");
  if (namesake.submission !== claim.submission) parts.push("submission");
  return { kind: "other files", parts };
}

type Bearing = Extract<Verdict, { readonly kind: (typeof RANK)[number] }>;

/** How far a row of the same files and figures bears out what the link calls them. */
function bearing(claim: Claim, model: SharedModel, { model: name, report, basis }: Candidate): Bearing {
  const names: Names = {
    ...(isModelCalled(name, model.name) ? {} : { model: name }),
    ...(isCalled(report.method, claim.method) ? {} : { method: report.method }),
  };
  if (!isIndependent(basis)) return { kind: "recomputed", basis, names };
  if (Object.keys(names).length > 0) return { kind: "renamed", basis, names };
  return { kind: basis.copiesTruth ? "copied" : "verified", basis, ...(isCalled(name, model.name) ? {} : { folder: name.slice(0, -model.name.length) }) };
}

/** Whether a name on the page is what a link calls it, which may have been cut there. */
function isCalled(here: string, shared: string): boolean {
  return asLinkText(here).normalize("NFC") === shared.normalize("NFC");
}

/** The same of a model: the page puts folders before the name where there are others of that name. */
function isModelCalled(here: string, shared: string): boolean {
  return isCalled(here, shared) || (shared !== "" && asLinkText(here).normalize("NFC").endsWith(`/${shared.normalize("NFC")}`));
}

export interface JudgedClaim {
  readonly key: string;
  readonly claim: Claim;
  readonly model: SharedModel;
  readonly verdict: Verdict;
}

/** The verdict on every row of a link. Of rows about the same files, one counts. O(claims + candidates). */
export function judgeAll(claims: readonly Claim[], models: readonly SharedModel[], candidates: readonly Candidate[]): JudgedClaim[] {
  const index = indexed(candidates);
  const rows = claims.flatMap((claim, place): JudgedClaim[] => {
    const model = models[claim.model];
    return model ? [{ key: String(place), claim, model, verdict: judge(claim, model, index) }] : [];
  });
  const counted = new Map<string, { readonly first: RowNames; readonly names: Set<string> }>();
  return rows.map((row) => {
    const { claim, model, verdict } = row;
    if (!isBearing(verdict)) return row;
    const names = { model: model.name, method: claim.method };
    const name = nameKey(names.model, names.method);
    const files = filesKey(model.inputs, claim.submission);
    const before = counted.get(files);
    if (!before) counted.set(files, { first: names, names: new Set([name]) });
    // Files that the reader has twice are borne out under both their names, but each name once.
    const isOther = before !== undefined && verdict.kind === "verified" && !before.names.has(name);
    before?.names.add(name);
    return !before || isOther ? row : { ...row, verdict: { kind: "repeated", earlier: before.first, basis: verdict.basis } };
  });
}

function isBearing(verdict: Verdict): verdict is Bearing {
  return (RANK as readonly string[]).includes(verdict.kind);
}
