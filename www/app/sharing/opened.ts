// The link the page was opened with, and how far what is on the page bears it out.

import { computed, effect, signal } from "@preact/signals";
import { models, scoredRows, type ScoredRow } from "../state/models";
import { fingerprintsOf, type Fingerprints } from "./fingerprints";
import { isShared } from "./fragment";
import { judge, type Candidate, type Verdict } from "./judge";
import type { Claim, SharedModel, SharedResults } from "./shared";

export type Opened =
  | { readonly kind: "none" }
  | { readonly kind: "damaged"; readonly message: string }
  | { readonly kind: "shared"; readonly results: SharedResults };

export const opened = signal<Opened>({ kind: "none" });

/** Version of the engine on this page, once a link has asked for it. */
export const engineHere = signal<string | undefined>(undefined);

/** The panel that shows the claims of the link. */
export const SHARED_PANEL = "shared";

export function isLinkOpen(): boolean {
  return opened.value.kind === "shared";
}

export interface JudgedClaim {
  readonly key: string;
  readonly claim: Claim;
  readonly model: SharedModel;
  readonly verdict: Verdict;
}

/** Nothing where hashing failed. */
const fingerprints = signal<ReadonlyMap<string, Fingerprints | undefined>>(new Map());
const asked = new Set<string>();

/** Named by content: the same rows of other files are others. */
function nameOf({ entry, reports }: ScoredRow): string {
  return `${entry.source.key}\n${reports.method}`;
}

// Hashing every model costs time, so it waits for a link that asks for it.
effect(() => {
  if (opened.value.kind !== "shared") return;
  for (const row of scoredRows.value) {
    const name = nameOf(row);
    if (asked.has(name)) continue;
    asked.add(name);
    const take = (found: Fingerprints | undefined) => (fingerprints.value = new Map(fingerprints.peek()).set(name, found));
    fingerprintsOf(row.entry.source.files, row.reports.method).then(take, () => {
      // Asked for again when the models change.
      asked.delete(name);
      take(undefined);
    });
  }
});

export const judged = computed<readonly JudgedClaim[]>(() => {
  if (opened.value.kind !== "shared") return [];
  const { claims, models: shared, protocol } = opened.value.results;
  const candidates = scoredRows.value.flatMap((row): Candidate[] => {
    const known = fingerprints.value.get(nameOf(row));
    return known ? [{ ...known, model: row.entry.id, report: row.reports[protocol] }] : [];
  });
  return claims.flatMap((claim, place) => {
    const model = shared[claim.model];
    return model ? [{ key: String(place), claim, model, verdict: judge(claim, model, candidates) }] : [];
  });
});

/** Whether anything on the page is still being scored or hashed, so that verdicts may change. */
export const judging = computed(
  () => models.value.some(({ status }) => status.kind === "waiting") || scoredRows.value.some((row) => !fingerprints.value.has(nameOf(row))),
);

/** How many claims there are of each verdict. */
export const tally = computed(() => {
  const counts: Record<Verdict["kind"], number> = { claimed: 0, uncheckable: 0, "other files": 0, differs: 0, verified: 0 };
  for (const { verdict } of judged.value) counts[verdict.kind] += 1;
  return counts;
});

/** Takes the link off the page and out of the address. What is on the page stays. */
export function closeLink(): void {
  opened.value = { kind: "none" };
  if (isShared(location.hash)) history.replaceState(null, "", `${location.pathname}${location.search}`);
}
