// Everything that is wrong with the input, of all models and of files that belong to none.

import { computed } from "@preact/signals";
import type { Diagnostic } from "../engine/contract";
import { brought, unplaced } from "../state/inbox";
import { models, type ModelEntry } from "../state/models";

export interface Finding extends Diagnostic {
  /** Absent for files that belong to no model. */
  readonly model?: string;
}

const RANK = { error: 0, warning: 1, note: 2 } as const;

/** Worst first; within a severity in the order of models and files. */
export const findings = computed<readonly Finding[]>(() => {
  const all: Finding[] = unplaced.value.map(({ path, reason }) => ({
    severity: "warning",
    file: path,
    message: reason,
    found: "",
    expected: "",
    hint: brought.value.has(path) ? "Say what it is, or rename it." : "",
  }));
  for (const entry of models.value) all.push(...findingsOf(entry));
  return all.sort((a, b) => RANK[a.severity] - RANK[b.severity]);
});

/** Findings that say the same of several places: one fault of a whole set is read once. Never empty. */
export function grouped(list: readonly Finding[]): readonly (readonly [Finding, ...Finding[]])[] {
  const groups = new Map<string, [Finding, ...Finding[]]>();
  for (const finding of list) {
    const { severity, message, expected, hint } = finding;
    const key = JSON.stringify([severity, message, expected, hint]);
    const group = groups.get(key);
    if (group) group.push(finding);
    else groups.set(key, [finding]);
  }
  return [...groups.values()];
}

const known = new WeakMap<ModelEntry, readonly Finding[]>();

function findingsOf(entry: ModelEntry): readonly Finding[] {
  let own = known.get(entry);
  if (!own) {
    own = findIn(entry);
    known.set(entry, own);
  }
  return own;
}

function findIn({ id, status }: ModelEntry): Finding[] {
  if (status.kind === "failed") {
    return [{ severity: "error", file: id, message: status.message, found: "", expected: "", hint: "", model: id }];
  }
  if (status.kind !== "scored") return [];
  const { info, reports } = status.result;
  // A report repeats what reading its files has found.
  const all = [...info.diagnostics, ...reports.flatMap(({ definition }) => definition.diagnostics)];
  return [...new Map(all.map((finding) => [JSON.stringify(finding), { ...finding, model: id }])).values()];
}

/** `file:line:column`, as far as known. */
export function placeOf({ file, line, column }: Diagnostic): string {
  return [file, line, column].filter((part) => part !== undefined).join(":");
}
