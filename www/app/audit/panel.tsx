// Whether the ground truths are what they say: points, parametric and implicit form held against
// each other.

import type { JSX } from "preact";
import { effect, signal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import type { Severity } from "../engine/contract";
import { models } from "../state/models";
import { selectedModel } from "../state/selection";
import { plural } from "../ui/format";
import { Icon } from "../ui/icon";
import { corrected, saveCorrected } from "./corrected";
import { FindingsTable } from "./findings-table";
import { MeasurementsTable } from "./measurements-table";
import { auditAll, audited, audits, found, type FoundIn } from "./state";
import "./audit.css";

const SEVERITIES: readonly Severity[] = ["error", "warning", "note"];

const wanted = signal<Severity | "all">("all");
const stopped = signal(false);

export default function AuditPanel(): JSX.Element {
  // Models that come while the panel is shown are audited as well.
  useEffect(
    () =>
      effect(() => {
        void models.value;
        if (!stopped.value) queueMicrotask(auditAll);
      }),
    [],
  );
  const shown = wanted.value === "all" ? found.value : found.value.filter(({ severity }) => severity === wanted.value);
  const selected = audited.value.find(({ entry }) => entry.id === selectedModel.value);
  const answer = selected?.outcome?.kind === "answered" ? selected.outcome.answer : undefined;
  return (
    <div class="audit">
      <div class="panel-tools">
        <p role="status">{summary(found.value)}</p>
        <Running />
        <select aria-label="Findings shown" value={wanted.value} onChange={(event) => (wanted.value = event.currentTarget.value as Severity | "all")}>
          <option value="all">All findings</option>
          {SEVERITIES.map((severity) => (
            <option key={severity} value={severity}>
              {severity}s only
            </option>
          ))}
        </select>
        <button
          type="button"
          disabled={corrected.value.length === 0}
          title="The surface files with wrong vectors replaced by exact conversions of those that are right; all others keep every digit"
          onClick={() => void saveCorrected()}
        >
          <Icon name="drop" />
          Save corrected files
          {corrected.value.length > 0 && ` of ${plural(corrected.value.length, "model")}`}
        </button>
      </div>
      {shown.length > 0 && <FindingsTable findings={shown} />}
      {shown.length === 0 && audits.progress.value === undefined && <Nothing />}
      {answer && selected && answer.audit.primitives.length > 0 && (
        <MeasurementsTable model={selected.entry.id} primitives={answer.audit.primitives} />
      )}
    </div>
  );
}

function summary(findings: readonly FoundIn[]): string {
  const done = audited.value.filter(({ outcome }) => outcome !== undefined);
  const wrong = new Set(findings.map(({ model }) => model));
  const clean = done.filter(({ entry }) => !wrong.has(entry.id)).length;
  const counts = SEVERITIES.flatMap((severity) => {
    const count = findings.filter((finding) => finding.severity === severity).length;
    return count > 0 ? [plural(count, severity)] : [];
  });
  const models = `${plural(done.length, "model")} audited`;
  return counts.length > 0 ? `${models}: ${counts.join(", ")}; nothing wrong with ${clean}` : `${models}: nothing wrong`;
}

function Running(): JSX.Element | null {
  const progress = audits.progress.value;
  if (progress) {
    return (
      <>
        <progress aria-label="Models audited" value={progress.done} max={progress.total} />
        <button
          type="button"
          onClick={() => {
            stopped.value = true;
            audits.stop();
          }}
        >
          Stop
        </button>
      </>
    );
  }
  if (!stopped.value) return null;
  return (
    <button
      type="button"
      onClick={() => {
        stopped.value = false;
        auditAll();
      }}
    >
      Audit the rest
    </button>
  );
}

function Nothing(): JSX.Element {
  const any = audited.value.some(({ outcome }) => outcome !== undefined);
  const every = audited.value.every(({ outcome }) => outcome !== undefined);
  return (
    <p class="empty">
      {found.value.length > 0 ? (
        "No findings of this severity."
      ) : any ? (
        <>
          <Icon name="check" /> Nothing to report: points, parametric and implicit forms agree in {every ? "every model" : "the models audited so far"}.
        </>
      ) : (
        "There is no model to audit."
      )}
    </p>
  );
}
