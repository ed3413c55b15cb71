// The counts and measures of the true primitive that is looked at, formula by formula.

import type { JSX } from "preact";
import * as format from "../../ui/format";
import { lookedAt, score } from "./state";

type Count = "TP" | "FP" | "FN" | "TN";

/** Numerator and denominator as the paper writes them; a 2 before a count doubles it. */
export const FORMULAS = {
  DSC: { over: "2 TP", under: "2 TP + FP + FN" },
  PPV: { over: "TP", under: "TP + FP" },
  TPR: { over: "TP", under: "TP + FN" },
  TNR: { over: "TN", under: "TN + FP" },
  NPV: { over: "TN", under: "TN + FN" },
  ACC: { over: "TP + TN", under: "TP + TN + FP + FN" },
} as const;

export type CountMeasure = keyof typeof FORMULAS;

export function Confusion(): JSX.Element | null {
  const counts = score.value?.counts[lookedAt.value];
  if (!counts) return null;
  return (
    <table class="confusion">
      <caption>Confusion table of the {NAMES[lookedAt.value]}</caption>
      <thead>
        <tr>
          <td />
          <th scope="col">predicted</th>
          <th scope="col">not predicted</th>
        </tr>
      </thead>
      <tbody>
        <tr>
          <th scope="row">{NAMES[lookedAt.value]}</th>
          <td data-outcome="tp">
            TP <b>{format.integer(counts.tp)}</b>
          </td>
          <td data-outcome="fn">
            FN <b>{format.integer(counts.fn)}</b>
          </td>
        </tr>
        <tr>
          <th scope="row">all else</th>
          <td data-outcome="fp">
            FP <b>{format.integer(counts.fp)}</b>
          </td>
          <td data-outcome="tn">
            TN <b>{format.integer(counts.tn)}</b>
          </td>
        </tr>
      </tbody>
    </table>
  );
}

export const NAMES = ["wall", "floor", "rest of the part"] as const;

export function Formulas({ stressed }: { stressed?: readonly CountMeasure[] | undefined }): JSX.Element | null {
  const counts = score.value?.counts[lookedAt.value];
  const row = score.value?.report.primitives[lookedAt.value];
  if (!counts || !row) return null;
  const numbers: Record<Count, number> = { TP: counts.tp, FP: counts.fp, FN: counts.fn, TN: counts.tn };
  const put = (formula: string) => formula.replace(/[TF][PN]/g, (name) => String(numbers[name as Count])).replace(/^2 (\d)/, "2·$1");
  return (
    <table class="formulas">
      <caption class="visually-hidden">The six measures with the numbers put in</caption>
      <tbody>
        {(Object.keys(FORMULAS) as CountMeasure[]).map((name) => {
          const { over, under } = FORMULAS[name];
          return (
            <tr key={name} data-stressed={stressed?.includes(name) === true}>
              <th scope="row">{name}</th>
              <td>
                ({over}) / ({under})
              </td>
              <td>
                ({put(over)}) / ({put(under)})
              </td>
              <td class="numeric">
                <b>{format.measure(name, row[name])}</b>
              </td>
            </tr>
          );
        })}
      </tbody>
    </table>
  );
}

/** MFE and directed Hausdorff distance of every painted prediction. */
export function Accuracy(): JSX.Element | null {
  const rows = score.value?.report.predictions ?? [];
  if (rows.length === 0) return <p class="hint">Nothing is predicted.</p>;
  return (
    <table class="formulas">
      <caption>Approximation accuracy of the predictions</caption>
      <thead>
        <tr>
          <th scope="col">Prediction</th>
          <th scope="col">Points</th>
          <th scope="col">MFE</th>
          <th scope="col">dHaus</th>
        </tr>
      </thead>
      <tbody>
        {rows.map((each) => (
          <tr key={each.prediction}>
            <th scope="row">{"ABCD"[each.prediction - 1]}</th>
            <td class="numeric">{format.integer(each.size)}</td>
            <td class="numeric">{format.measure("MFE", each.MFE)}</td>
            <td class="numeric">{format.measure("dHaus", each.dHaus)}</td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}
