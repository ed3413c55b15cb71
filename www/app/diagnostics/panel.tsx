// What is wrong with the input, said so that a person can act on it.

import type { JSX } from "preact";
import { signal } from "@preact/signals";
import { engine } from "../engine/client";
import type { Severity } from "../engine/contract";
import { copy } from "../export/download";
import { selectedModel, selectModel } from "../state/selection";
import { integer, plural } from "../ui/format";
import { Icon } from "../ui/icon";
import { Marked } from "../ui/marked";
import { findings, grouped, placeOf, type Finding } from "./findings";
import { Ways } from "./ways";

const onlySelected = signal(false);

/** More would not be read, and would slow the page. */
const SHOWN_AT_MOST = 500;

export default function DiagnosticsPanel(): JSX.Element {
  const all = findings.value;
  const wanted = onlySelected.value ? all.filter(({ model }) => model === selectedModel.value) : all;
  const groups = grouped(wanted);
  const shown = groups.slice(0, SHOWN_AT_MOST);
  const more = groups.slice(SHOWN_AT_MOST).flat().length;
  return (
    <div class="diagnostics">
      <div class="panel-tools">
        <p>{summary(wanted)}</p>
        <label class="check">
          <input
            type="checkbox"
            checked={onlySelected.value}
            onChange={(event) => (onlySelected.value = event.currentTarget.checked)}
          />
          Selected model only
        </label>
        <button type="button" disabled={wanted.length === 0} onClick={() => void copyAll(wanted)}>
          <Icon name="copy" />
          Copy all
        </button>
      </div>
      {shown.length === 0 ? (
        <p class="empty">
          <Icon name="check" /> Nothing to report: every file was placed and read in full.
        </p>
      ) : (
        <ul>
          {shown.map((group, i) => (
            <Item key={i} group={group} />
          ))}
        </ul>
      )}
      {more > 0 && <p class="empty">… and {integer(more)} more; “Copy all” has them.</p>}
    </div>
  );
}

function summary(list: readonly Finding[]): string {
  const count = (severity: Severity) => list.filter((finding) => finding.severity === severity).length;
  return (["error", "warning", "note"] as const)
    .flatMap((severity) => (count(severity) > 0 ? [plural(count(severity), severity)] : []))
    .join(", ");
}

/** Places of one finding that are named; of more the number is. */
const PLACES_AT_MOST = 8;

function Item({ group }: { group: readonly [Finding, ...Finding[]] }): JSX.Element {
  const { severity, message, found, expected, hint } = group[0];
  const single = group.length === 1;
  return (
    <li data-severity={severity}>
      <span class={`mark ${severity}`}>
        <Icon name={severity === "note" ? "note" : "error"} />
        {severity}
      </span>
      <div>
        <p class="message">
          <Marked text={message} />
          {!single && <small> at {group.length} places</small>}
        </p>
        {((single && found) || expected) && (
          <p class="details">
            <Marked text={[single && found && `found ${found}`, expected && `expected ${expected}`].filter(Boolean).join(", ")} />
          </p>
        )}
        {hint && (
          <p class="hint">
            <Marked text={hint} />
          </p>
        )}
        {group[0].model === undefined && <Ways paths={group.map(({ file }) => file)} />}
        {group.slice(0, PLACES_AT_MOST).map((finding, place) => (
          <Place key={place} finding={finding} />
        ))}
        {group.length > PLACES_AT_MOST && <p class="place">… and {integer(group.length - PLACES_AT_MOST)} more</p>}
      </div>
      <button type="button" class="icon" aria-label="Copy this finding" onClick={() => void copyAll(group)}>
        <Icon name="copy" />
      </button>
    </li>
  );
}

function Place({ finding }: { finding: Finding }): JSX.Element {
  const { model } = finding;
  return (
    <p class="place">
      {model !== undefined && (
        <button type="button" class="link" onClick={() => selectModel(model)}>
          {model}
        </button>
      )}
      <code>{placeOf(finding)}</code>
    </p>
  );
}

async function copyAll(list: readonly Finding[]): Promise<void> {
  const lines = await engine.run((api) => api.oneLines(list));
  await copy(lines.join("\n"), plural(list.length, "finding"));
}
