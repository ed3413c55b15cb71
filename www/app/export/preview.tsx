// What a table will read, while the reader chooses what it shows.

import type { JSX } from "preact";
import { computed, effect, signal, useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import type { MethodSummary } from "../engine/contract";
import { scoredRows } from "../state/models";
import { protocol } from "../state/settings";
import { PREVIEWED, type TableFormat } from "./tables";
import { engineVersion, summariesOf, unhashed } from "./results";
import { rowsFor, wanted } from "./wanted";

/** Rows of results in the preview: of what follows the reader learns nothing new. */
const MOST = 120;

/** The rows of all results; the files are hashed when a table is saved. */
export const rows = computed(() => rowsFor(unhashed(scoredRows.value, protocol.value, version.value)));

const version = signal("");
const summaries = signal<readonly MethodSummary[]>([]);

/** Asks for the means of what the tables show, and of what comes, until the result is called. */
function follow(): () => void {
  let latest = 0;
  void engineVersion().then((said) => (version.value = said), () => {});
  return effect(() => {
    const own = ++latest;
    // The section says what went wrong when a table is saved.
    void summariesOf(rows.value).then((found) => own === latest && (summaries.value = found), () => {});
  });
}

export function Preview(): JSX.Element {
  const chosen = useSignal<TableFormat | undefined>(PREVIEWED[0]);
  useEffect(follow, []);
  const shown = rows.value.slice(0, MOST);
  const text = chosen.value?.write(shown, summaries.value, wanted.value) ?? "";
  return (
    <div class="table-preview">
      <label>
        Preview of{" "}
        <select
          value={chosen.value?.title}
          onChange={({ currentTarget }) => (chosen.value = PREVIEWED.find(({ title }) => title === currentTarget.value))}
        >
          {PREVIEWED.map(({ title }) => (
            <option key={title}>{title}</option>
          ))}
        </select>
        {rows.value.length > MOST && ` (the first ${MOST} rows)`}
      </label>
      {/* Keyboards scroll it too. */}
      <pre tabIndex={0} aria-label="Preview" data-testid="table-preview">
        {text}
      </pre>
    </div>
  );
}
