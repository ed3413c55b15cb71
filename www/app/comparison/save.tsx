// What is compared as a file, in the formats of the command line that are tables.

import type { JSX } from "preact";
import { SHEET_FORMATS, type Sheets } from "../../shared/formats/sheet.mjs";
import { download } from "../export/download";
import { TABLE_FORMATS, type TableFormat } from "../export/tables";
import { engineVersion } from "../export/results";
import { notify } from "../state/notices";

const SAVED = Object.entries(SHEET_FORMATS).flatMap(([name, write]) =>
  TABLE_FORMATS.filter(({ title }) => title.toLowerCase() === name).map((format) => ({ format, write })),
);

export function SaveButtons({ name, sheets }: { name: string; sheets: (engine: string) => Sheets }): JSX.Element {
  const save = async ({ title, file: { type, extension } }: TableFormat, write: (sheets: Sheets) => string) => {
    try {
      const text = write(sheets(await engineVersion()));
      download(`${name}.${extension}`, new Blob([text], { type: `${type};charset=utf-8` }));
    } catch (error) {
      notify(`${title} could not be written: ${error instanceof Error ? error.message : String(error)}`, "error");
    }
  };
  return (
    <div class="row" role="group" aria-label="Save the comparison">
      {SAVED.map(({ format, write }) => (
        <button key={format.title} type="button" aria-label={`Save the comparison as ${format.title}`} onClick={() => void save(format, write)}>
          {format.title}
        </button>
      ))}
    </div>
  );
}
