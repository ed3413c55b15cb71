// The line that repeats all this in a terminal.

import type { JSX } from "preact";
import { computed } from "@preact/signals";
import { brought, overrides } from "../state/inbox";
import { scoredRows } from "../state/models";
import { protocol } from "../state/settings";
import { commandLine, type SampleOnScreen } from "./command";
import { copy } from "./download";

/** The submission every sample comes with; what else there is was fitted here. */
const IMPERFECT = "Imperfect";

const entries = computed(() => [...new Set(scoredRows.value.map(({ entry }) => entry))]);

const line = computed(() => {
  const samples = entries.value.flatMap(({ origin }): SampleOnScreen[] =>
    origin.kind === "sample" ? [{ part: origin.part, options: origin.options }] : [],
  );
  return commandLine({ paths: [...brought.value.keys()], samples, protocol: protocol.value });
});

/** What the line cannot say. */
const caveats = computed(() => {
  const found: string[] = [];
  if (Object.keys(overrides.value).length > 0) {
    found.push("Corrections made under Files are not in it: rename the files, so that their names say the same.");
  }
  const fitted = entries.value.some(({ origin, source }) =>
    source.files.some(
      ({ path, method }) =>
        method !== undefined && !brought.value.has(path) && !(origin.kind === "sample" && method === IMPERFECT),
    ),
  );
  if (fitted) found.push("Submissions made on this page are not in it: save them as a zip and add its name to the line.");
  return found;
});

export function CommandSection(): JSX.Element | null {
  const text = line.value;
  if (text === undefined) return null;
  return (
    <section>
      <h3>A command</h3>
      <p>Repeats these results with the same engine, run where the dropped files and folders are.</p>
      <div class="copied-line">
        <code tabIndex={0} data-testid="command">
          {text}
        </code>
        <button type="button" onClick={() => void copy(text, "Command")}>
          Copy as command
        </button>
      </div>
      {caveats.value.map((caveat) => (
        <p key={caveat} class="hint">
          {caveat}
        </p>
      ))}
    </section>
  );
}
