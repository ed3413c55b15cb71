// The selected model: its figures, and its points in truth and prediction.

import type { JSX } from "preact";
import { ExplainButton } from "../measures/explain";
import { MEASURES } from "../measures/measures";
import { modelById, type ModelEntry } from "../state/models";
import { selectedMethod, selectedModel, selectedReports, selectModel } from "../state/selection";
import { protocol } from "../state/settings";
import * as format from "../ui/format";
import { Picture } from "./picture";

export function Stage(): JSX.Element {
  const entry = modelById(selectedModel.value);
  return (
    <section class="stage" aria-label="Selected model">
      {entry && (
        <header class="stage-head">
          <Title entry={entry} />
          <Readouts />
        </header>
      )}
      <Picture />
    </section>
  );
}

function Title({ entry }: { entry: ModelEntry }): JSX.Element {
  const { status } = entry;
  const report = selectedReports.value?.[protocol.value];
  const info = status.kind === "scored" ? status.result.info : undefined;
  return (
    <div class="stage-title">
      <h2>{entry.id}</h2>
      {info && info.methods.length > 0 && (
        <fieldset class="switch">
          <legend class="visually-hidden">Method</legend>
          {info.methods.map((method) => (
            <label key={method}>
              <input
                type="radio"
                name="method"
                checked={method === selectedMethod.value}
                onChange={() => selectModel(entry.id, method)}
              />
              <span>{method}</span>
            </label>
          ))}
        </fieldset>
      )}
      {info && (
        <p>
          {format.plural(info.points, "point")}
          {report && `, ${report.truth} true and ${report.predicted} predicted primitives`}
          {!info.hasTruth && ", no ground truth"}
        </p>
      )}
    </div>
  );
}

function Readouts(): JSX.Element | null {
  const report = selectedReports.value?.[protocol.value];
  if (!report) return null;
  return (
    <dl class="readouts">
      {MEASURES.map((measure) => (
        <div key={measure}>
          <dt>
            <ExplainButton measure={measure} named />
          </dt>
          <dd>{format.measure(measure, report.mean[measure])}</dd>
        </div>
      ))}
    </dl>
  );
}
