// The measures of a submission, as a lesson ends with them.

import type { JSX } from "preact";
import type { Report } from "../engine/contract";
import { MEASURES } from "../measures/measures";
import * as format from "../ui/format";

export function MeanScore({ report }: { report: Report }): JSX.Element {
  return (
    <table class="formulas">
      <caption>Score, by definition</caption>
      <tbody>
        {MEASURES.map((name) => (
          <tr key={name}>
            <th scope="row">{name}</th>
            <td class="numeric">{format.measure(name, report.mean[name])}</td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}
