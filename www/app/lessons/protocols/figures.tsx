// The prediction by every protocol.

import type { JSX } from "preact";
import type { Figure } from "../../engine/contract";
import { PROTOCOLS_OF_FIELD, written } from "../../field/figures";
import { lists, members, report } from "./state";

/** What the protocols say, those that the step is about stressed. */
export function Scores({ stressed }: { stressed: readonly Figure[] }): JSX.Element | null {
  const found = report.value;
  if (!found) return null;
  return (
    <table class="formulas">
      <caption>
        {lists.value.length} predicted, {members.value.length} true
      </caption>
      <tbody>
        {PROTOCOLS_OF_FIELD.map((figure) => (
          <tr key={figure.key} data-stressed={stressed.includes(figure.key)}>
            <th scope="row">{figure.title}</th>
            <td class="numeric">
              <b>{written(figure, found.figures[figure.key])}</b>
            </td>
            <td>
              <meter min={0} max={1} value={found.figures[figure.key] ?? 0} aria-hidden="true" />
            </td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}
