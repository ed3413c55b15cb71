// What is shown as a file: all figures, in the formats of the command line.

import type { JSX } from "preact";
import { TABLE_FORMATS, type TableFormat } from "../export/tables";
import { download } from "../export/download";
import { filesOfMethod, hashed } from "../export/hashes";
import { engineVersion } from "../export/results";
import { engine } from "../engine/client";
import { modelById } from "../state/models";
import { notify } from "../state/notices";
import { answers, scale } from "./state";

export function SaveButtons(): JSX.Element {
  return (
    <div class="row" role="group" aria-label="Save all figures">
      {TABLE_FORMATS.map((format) => (
        <button key={format.title} type="button" aria-label={`Save figures as ${format.title}`} onClick={() => void save(format)}>
          {format.title}
        </button>
      ))}
    </div>
  );
}

async function save({ title, file: { type, extension } }: TableFormat): Promise<void> {
  try {
    const version = await engineVersion();
    const results = await Promise.all(
      answers.peek().reports.map(async (report) => ({
        ...report,
        engine: version,
        files: await hashed(filesOfMethod(modelById(report.model)?.source.files ?? [], report.method)),
      })),
    );
    const text = await engine.run((api) => api.fieldText(results, scale.peek(), extension));
    download(`fit4cad-protocols.${extension}`, new Blob([text], { type: `${type};charset=utf-8` }));
  } catch (error) {
    notify(`${title} could not be written: ${error instanceof Error ? error.message : String(error)}`, "error");
  }
}
