// Everything that is wrong with the input, of all models and of files that belong to none.

import { computed } from "@preact/signals";
import type { Diagnostic } from "../engine/contract";
import { brought, unplaced } from "../state/inbox";
import { models } from "../state/models";

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
    hint: brought.value.has(path) ? "Say what it is under Files, or rename it." : "",
  }));
  for (const { id, status } of models.value) {
    if (status.kind === "failed") {
      all.push({ severity: "error", file: id, message: status.message, found: "", expected: "", hint: "", model: id });
    }
    if (status.kind !== "scored") continue;
    const { info, reports } = status.result;
    const known = new Set<string>();
    for (const finding of [...info.diagnostics, ...reports.flatMap(({ definition }) => definition.diagnostics)]) {
      // A report repeats what reading its files has found.
      const text = asText(finding);
      if (!known.has(text)) all.push({ ...finding, model: id });
      known.add(text);
    }
  }
  return all.sort((a, b) => RANK[a.severity] - RANK[b.severity]);
});

/** `file:line:column`, as far as known. */
export function placeOf({ file, line, column }: Diagnostic): string {
  return [file, line, column].filter((part) => part !== undefined).join(":");
}

/** One line, as a compiler would print it. */
export function asText(finding: Diagnostic): string {
  const { severity, message, found, expected, hint } = finding;
  const details = [found && `found ${found}`, expected && `expected ${expected}`].filter(Boolean).join(", ");
  return `${placeOf(finding)}: ${severity}: ${message}${details && ` (${details})`}${hint && `. ${hint}`}`;
}
