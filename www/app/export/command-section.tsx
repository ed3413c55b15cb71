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
  const paths = [...brought.value.keys()];
  return commandLine({ paths, samples, corrections: overrides.value, protocol: protocol.value });
});

/** Whether there are submissions that no file holds, which the line hence cannot name. */
const hasFitted = computed(() =>
  entries.value.some(({ origin, source }) =>
    source.files.some(
      ({ path, method }) =>
        method !== undefined && !brought.value.has(path) && !(origin.kind === "sample" && method === IMPERFECT),
    ),
  ),
);

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
      {hasFitted.value && (
        <p class="hint">
          Submissions made on this page are not in it: save them as a zip and add its name to the line.
        </p>
      )}
    </section>
  );
}
