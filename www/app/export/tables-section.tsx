// The summary as a file or on the clipboard.

import type { JSX } from "preact";
import { scoredRows } from "../state/models";
import { notify } from "../state/notices";
import { protocol } from "../state/settings";
import { plural } from "../ui/format";
import { copy, download } from "./download";
import { Preview, rows } from "./preview";
import { resultsOf, summariesOf } from "./results";
import { TableOptions } from "./table-options";
import { TABLE_FORMATS, type TableFormat } from "./tables";
import { rowsFor, wanted } from "./wanted";

export function TablesSection(): JSX.Element {
  return (
    <section>
      <h3>Tables</h3>
      <p>
        {plural(scoredRows.value.length, "row")} by protocol {protocol.value}, with the engine's version and the SHA-256
        of each file. JSON holds everything; the others show what you choose here.
      </p>
      <TableOptions adds={rows.value.length > scoredRows.value.length} />
      <Preview />
      <ul class="exports">
        {TABLE_FORMATS.map((format) => (
          <li key={format.title}>
            <span>
              <strong>{format.title}</strong> {format.what}
            </span>
            <button type="button" aria-label={`Save ${format.title}`} onClick={() => void hand(format, save)}>
              Save
            </button>
            <button type="button" aria-label={`Copy ${format.title}`} onClick={() => void hand(format, put)}>
              Copy
            </button>
          </li>
        ))}
      </ul>
    </section>
  );
}

function save({ file: { type, extension } }: TableFormat, text: string): void {
  download(`fit4cad-${protocol.peek()}.${extension}`, new Blob([text], { type: `${type};charset=utf-8` }));
}

function put({ title }: TableFormat, text: string): Promise<void> {
  return copy(text, title);
}

async function hand(format: TableFormat, over: (format: TableFormat, text: string) => void | Promise<void>): Promise<void> {
  try {
    const results = await resultsOf(scoredRows.peek(), protocol.peek());
    const shown = format.isTable ? rowsFor(results) : results;
    await over(format, format.write(shown, await summariesOf(shown), wanted.peek()));
  } catch (error) {
    notify(`${format.title} could not be written: ${error instanceof Error ? error.message : String(error)}`, "error");
  }
}
