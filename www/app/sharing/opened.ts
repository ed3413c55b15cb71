// How far what is on the page bears out the link it was opened with.

import { computed, effect, signal } from "@preact/signals";
import { paced } from "../engine/pace";
import { models, scoredRows, type ScoredRow } from "../state/models";
import { candidateOf } from "./candidates";
import { evidenceOf, type Evidence } from "./fingerprints";
import { judgeAll, type Candidate, type JudgedClaim, type Verdict } from "./judge";
import { opened, standing } from "./state";

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

let following = false;

/**
 * From the first link on, as long as the page is open: hashes what is on the page while a link is, which costs time, and has the
 * panel's title tell how it stands.
 */
export function followLink(): void {
  if (following) return;
  following = true;
  effect(hash);
  effect(() => {
    const { verified, differs } = tally.value;
    standing.value = { all: judged.value.length, verified, differs };
  });
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
