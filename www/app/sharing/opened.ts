// The link the page was opened with, and how far what is on the page bears it out.

import { computed, effect, signal } from "@preact/signals";
import { paced } from "../engine/pace";
import { models, scoredRows, type ScoredRow } from "../state/models";
import { takeBack } from "../state/settings";
import { candidateOf } from "./candidates";
import { evidenceOf, type Evidence } from "./fingerprints";
import { isShared } from "../state/fragment";
import { judgeAll, type Candidate, type JudgedClaim, type Verdict } from "./judge";
import type { SharedResults } from "./shared";

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

/** Nothing where hashing failed. */
const evidence = signal<ReadonlyMap<string, Evidence | undefined>>(new Map());
const asked = new Set<string>();
let arrived = new Map<string, Evidence | undefined>();

function take(name: string, found: Evidence | undefined): void {
  arrived.set(name, found);
  show();
}

const show = paced(() => {
  evidence.value = new Map([...evidence.peek(), ...arrived]);
  arrived = new Map();
});

/** Named by content: the same rows of other files are others. */
function nameOf({ entry, reports }: ScoredRow): string {
  return `${entry.source.key}\n${reports.method}`;
}

/** Hashes what is on the page while a link is open, until the result is called. It costs time, so it waits for a link that asks for it. */
export function hashForLink(): () => void {
  return effect(hash);
}

function hash(): void {
  if (opened.value.kind !== "shared") return;
  for (const row of scoredRows.value) {
    const name = nameOf(row);
    if (asked.has(name)) continue;
    asked.add(name);
    evidenceOf(row.entry.source.files, row.reports.method).then(
      (found) => take(name, found),
      () => {
        // Asked for again when the models change.
        asked.delete(name);
        take(name, undefined);
      },
    );
  }
}

export const judged = computed<readonly JudgedClaim[]>(() => {
  if (opened.value.kind !== "shared") return [];
  const { claims, models: shared, protocol } = opened.value.results;
  const candidates = scoredRows.value.flatMap((row): Candidate[] => {
    const known = evidence.value.get(nameOf(row));
    return known ? [candidateOf(row, known, protocol)] : [];
  });
  return judgeAll(claims, shared, candidates);
});

/** Whether anything on the page is still being scored or hashed, so that verdicts may change. */
export const judging = computed(
  () => models.value.some(({ status }) => status.kind === "waiting") || scoredRows.value.some((row) => !evidence.value.has(nameOf(row))),
);

/** How many claims there are of each verdict. */
export const tally = computed(() => tallyOf(judged.value));

export function tallyOf(rows: readonly JudgedClaim[]): Readonly<Record<Verdict["kind"], number>> {
  const counts = {
    claimed: 0,
    uncheckable: 0,
    "other files": 0,
    differs: 0,
    repeated: 0,
    recomputed: 0,
    renamed: 0,
    copied: 0,
    verified: 0,
  };
  for (const { verdict } of rows) counts[verdict.kind] += 1;
  return counts;
}

/** Takes the link, and the settings it came with, off the page and out of the address. The models stay. */
export function closeLink(): void {
  opened.value = { kind: "none" };
  takeBack();
  if (isShared(location.hash)) history.replaceState(null, "", `${location.pathname}${location.search}`);
}
