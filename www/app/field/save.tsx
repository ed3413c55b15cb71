// What is shown as a file: all figures, in the formats of the command line.

import type { JSX } from "preact";
import type { ModelSource, Particulars } from "../../worker/protocol";
import { TABLE_FORMATS, type TableFormat } from "../export/tables";
import { download } from "../export/download";
import { filesOfMethod, hashed } from "../export/hashes";
import { engineVersion } from "../export/results";
import { engine } from "../engine/client";
import type { FieldReport } from "../engine/contract";
import { modelById } from "../state/models";
import { notify } from "../state/notices";
import { answers, particulars, scale, withParticulars } from "./state";

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
    const asked = new Map<string, Promise<Particulars>>();
    const results = await Promise.all(
      answers.peek().reports.flatMap((report) => {
        const source = modelById(report.model)?.source;
        if (!source) return [];
        const own = asked.get(source.key) ?? particularsOf(source);
        asked.set(source.key, own);
        return resultOf(report, source, own, version);
      }),
    );
    const text = await engine.run((api) => api.fieldText(results, scale.peek(), extension));
    download(`fit4cad-protocols.${extension}`, new Blob([text], { type: `${type};charset=utf-8` }));
  } catch (error) {
    notify(`${title} could not be written: ${error instanceof Error ? error.message : String(error)}`, "error");
  }
}

async function resultOf(report: FieldReport, source: ModelSource, own: Promise<Particulars>, version: string) {
  const files = await hashed(filesOfMethod(source.files, report.method));
  return { ...withParticulars(report, await own), engine: version, files };
}

/** Those that are known already; else asked for now. */
function particularsOf(source: ModelSource): Promise<Particulars> {
  const known = particulars.peek().outcomes.peek().get(source.key);
  if (known?.kind === "answered") return Promise.resolve(known.answer);
  const { normalisation } = scale.peek();
  return engine.run((api) => api.particulars(source, normalisation));
}
