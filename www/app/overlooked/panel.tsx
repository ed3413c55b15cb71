// What the paper's measures do not show of the selected submission.

import type { ComponentChildren, JSX } from "preact";
import type { Report } from "../engine/contract";
import { predictionColours } from "../stage/colouring";
import { selectedPrimitive, selectedReports, togglePrimitive, type Side } from "../state/selection";
import { protocol } from "../state/settings";
import * as format from "../ui/format";
import { Swatch } from "../ui/swatch";
import { segmentColour, UNSEGMENTED } from "../view/palette";

export default function OverlookedPanel(): JSX.Element {
  const report = selectedReports.value?.[protocol.value];
  if (!report) return <p class="empty">Choose a model that is scored.</p>;
  const { hidden } = report;
  return (
    <div class="overlooked">
      <Fact
        title="Missed"
        figure={`${hidden.missed.length} of ${report.truth}`}
        text="True primitives that share no point with any prediction."
      >
        <Numbers report={report} side="truth" numbers={hidden.missed} />
      </Fact>
      <Fact
        title="Merged"
        figure={`${hidden.merged.length} of ${report.truth}`}
        text="True primitives whose match serves another one as well."
      >
        <Numbers report={report} side="truth" numbers={hidden.merged} />
      </Fact>
      <Fact
        title="Spurious"
        figure={`${hidden.spurious.length} of ${report.predicted}`}
        text="Predictions that are the match of no true primitive. The classification measures never look at them."
      >
        <Numbers report={report} side="prediction" numbers={hidden.spurious} />
      </Fact>
      <Fact
        title="DSC from the prediction's side"
        figure={format.measure("DSC", hidden.prediction_dsc)}
        text={`Mean over predictions, each against its most overlapping true primitive. From the truth's side: ${format.measure("DSC", report.mean.DSC)}.`}
      />
      <Fact
        title="Points labelled"
        figure={format.share(hidden.labelled)}
        text={`Share of the cloud that some prediction lists. The ground truth lists ${format.share(hidden.truth_labelled)}.`}
      />
      <Confusion report={report} />
    </div>
  );
}

interface FactProps {
  readonly title: string;
  readonly figure: string;
  readonly text: string;
  readonly children?: ComponentChildren;
}

function Fact({ title, figure, text, children }: FactProps): JSX.Element {
  return (
    <section>
      <h3>{title}</h3>
      <p class="figure">{figure}</p>
      <p class="hint">{text}</p>
      {children}
    </section>
  );
}

function Numbers({ report, side, numbers }: { report: Report; side: Side; numbers: readonly number[] }): JSX.Element | null {
  if (numbers.length === 0) return null;
  const all =
    side === "truth" ? report.primitives.map(({ truth }) => truth) : report.predictions.map(({ prediction }) => prediction);
  const colours = side === "truth" ? all.map((_, place) => segmentColour(place)) : predictionColours(report, all.length);
  return (
    <ul class="numbers">
      {numbers.map((number) => {
        const index = all.indexOf(number);
        const selected = selectedPrimitive.value?.side === side && selectedPrimitive.value.index === index;
        return (
          <li key={number}>
            <button type="button" aria-pressed={selected} onClick={() => togglePrimitive({ side, index })}>
              <Swatch colour={colours[index] ?? UNSEGMENTED} />
              {number}
            </button>
          </li>
        );
      })}
    </ul>
  );
}

/** Rows and columns that hold nothing are left out, but for the five types on the diagonal. */
function Confusion({ report }: { report: Report }): JSX.Element {
  const { truth, match, counts } = report.hidden.types;
  const used = (row: number) => counts[row]?.some((count) => count > 0) ?? false;
  const reached = (column: number) => counts.some((row) => (row[column] ?? 0) > 0);
  const rows = truth.map((name, at) => ({ name, at })).filter(({ at }) => used(at));
  const columns = match.map((name, at) => ({ name, at })).filter(({ name, at }) => reached(at) || rows.some((row) => row.name === name));
  return (
    <section class="confusion">
      <h3>Types</h3>
      <table>
        <caption>True primitives by their type and the type of their match</caption>
        <thead>
          <tr>
            <th scope="col">True type</th>
            {columns.map(({ name }) => (
              <th key={name} scope="col" class="numeric">
                {name}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {rows.map((row) => (
            <tr key={row.name}>
              <th scope="row">{row.name}</th>
              {columns.map((column) => {
                const count = counts[row.at]?.[column.at] ?? 0;
                const kind = count === 0 ? "none" : row.name === column.name ? "right" : "wrong";
                return (
                  <td key={column.name} class={`numeric ${kind}`}>
                    {count}
                  </td>
                );
              })}
            </tr>
          ))}
        </tbody>
      </table>
    </section>
  );
}
