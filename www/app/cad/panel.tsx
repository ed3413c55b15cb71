// What became of the faces of a STEP file, and importing it again in another way.

import type { JSX } from "preact";
import type { ImportReport } from "../../generated/cad/cad.js";
import { sentence } from "../../shared/text.mjs";
import { madeOfStep, stepOf } from "../state/step";
import { modelById } from "../state/models";
import { selectedModel, selectModel } from "../state/selection";
import * as format from "../ui/format";
import { Faces } from "./faces";
import { ImportForm } from "./form";
import "./cad.css";

export default function CadPanel(): JSX.Element {
  const entry = modelById(selectedModel.value);
  const step = entry && stepOf(entry);
  if (!entry || !step) return <Others />;
  return (
    <div class="cad">
      <Facts path={step.path} report={step.report} />
      <ImportForm id={entry.id} step={step} />
      <Faces id={entry.id} report={step.report} />
    </div>
  );
}

/** What there is instead, where the selected model was not made of a STEP file. */
function Others(): JSX.Element {
  return (
    <div class="cad">
      <p>{selectedModel.value ?? "This model"} was not made of a STEP file. Those that were:</p>
      <p class="cad-others">
        {madeOfStep.value.map(({ id }) => (
          <button key={id} type="button" onClick={() => selectModel(id)}>
            {id}
          </button>
        ))}
      </p>
    </div>
  );
}

/** Beyond this the list would push everything else out of sight; the others are in the table of faces or of their kind. */
const MOST_WORDS = 20;

function Facts({ path, report }: { path: string; report: ImportReport }): JSX.Element {
  const { system, schema, bodies, instances, diagonal, area, spacing, faces, lost } = report;
  const met = faces.filter(({ points }) => points > 0).length;
  const figure = (value: number) => Number(value.toPrecision(4)).toLocaleString("en", { maximumSignificantDigits: 4 });
  const facts: [string, string][] = [
    ["File", path],
    ["Written by", [system, schema].filter((words) => words !== "").join(", ") || "the file does not say"],
    ["Bodies", instances === bodies ? format.integer(bodies) : `${format.integer(bodies)}, ${format.plural(instances, "instance")}`],
    ["Faces", [format.integer(faces.length), met === faces.length ? "all in the cloud" : `${format.integer(met)} with points`, ...(lost > 0 ? [`${format.integer(lost)} left out`] : [])].join(", ")],
    ["Diagonal", `${figure(diagonal)} mm`],
    ["Area", `${figure(area)} mm²`],
    ["Spacing", `${figure(spacing)} mm`],
  ];
  const words = [...report.leftOut.map((each) => `Left out: ${each}`), ...report.warnings];
  return (
    <section aria-label="The STEP file">
      <dl class="cad-facts">
        {facts.map(([name, value]) => (
          <div key={name}>
            <dt>{name}</dt>
            <dd>{value}</dd>
          </div>
        ))}
      </dl>
      {words.length > 0 && (
        <ul class="cad-words">
          {words.slice(0, MOST_WORDS).map((each) => (
            <li key={each}>{sentence(each)}</li>
          ))}
          {words.length > MOST_WORDS && <li>… and {format.integer(words.length - MOST_WORDS)} more.</li>}
        </ul>
      )}
    </section>
  );
}
