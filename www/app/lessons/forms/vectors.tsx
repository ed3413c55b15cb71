// The two vectors of a surface, entry by entry.

import type { JSX } from "preact";
import { comparison, predicted, truth, vectors } from "./state";

export function entry(value: number): string {
  const size = Math.abs(value);
  if (value === 0) return "0";
  const text = size < 0.001 || size >= 1000 ? value.toExponential(0) : value.toFixed(3);
  return text.replaceAll("-", "−");
}

function Vector({ names, values, marked }: { names: readonly string[]; values: readonly number[]; marked?: readonly number[] }): JSX.Element {
  return (
    <dl class="vector">
      {values.map((value, place) => (
        <div key={place} data-opposite={marked?.includes(place) === true}>
          <dt>{names[place] ?? place + 1}</dt>
          <dd>{entry(value)}</dd>
        </div>
      ))}
    </dl>
  );
}

/** Columns of the parametric form, as the paper's appendix has them. */
const COLUMNS: Readonly<Record<string, readonly string[]>> = {
  Plane: ["a", "b", "c"],
  Cylinder: ["a", "b", "c", "d"],
  Cone: ["a", "b", "c", "d", "e", "f"],
  Sphere: ["a", "b", "c", "d"],
  Torus: ["a", "b", "c", "d", "e", "f"],
};

export function BothForms(): JSX.Element | null {
  const forms = predicted.value;
  if (!forms) return null;
  const columns = COLUMNS[forms.surface.type] ?? [];
  const names = columns.flatMap((column) => ["x", "y", "z"].map((axis) => `${column}·${axis}`));
  return (
    <>
      <h3>Parametric: {forms.parametric.length} numbers</h3>
      <Vector names={names} values={forms.parametric} />
      <h3>Implicit: {forms.implicit.length} numbers</h3>
      <Vector names={forms.terms} values={forms.implicit} />
    </>
  );
}

export function Compared(): JSX.Element | null {
  const [mine, other] = vectors.value ?? [];
  const names = truth.value?.terms ?? [];
  if (!mine || !other) return null;
  const marked = comparison.value?.opposite ?? [];
  return (
    <>
      <Distances />
      <h3>Predicted</h3>
      <Vector names={names} values={mine} marked={marked} />
      <h3>True</h3>
      <Vector names={names} values={other} marked={marked} />
      {marked.length > 0 && <p class="hint">Framed: entries of opposite sign.</p>}
    </>
  );
}

export function written(value: number | null | undefined): string {
  if (value === null || value === undefined) return "n/a";
  return value !== 0 && value < 0.0001 ? value.toExponential(1).replace("e-", "e−") : value.toFixed(4);
}

export function Distances(): JSX.Element {
  const { definition, published } = comparison.value ?? {};
  return (
    <table class="formulas">
      <caption>Coefficient distance d1</caption>
      <tbody>
        <tr>
          <th scope="row">by definition</th>
          <td>the smaller of |v − v′| and |v + v′|</td>
          <td class="numeric">
            <b data-d1="definition">{written(definition)}</b>
          </td>
        </tr>
        <tr>
          <th scope="row">as published</th>
          <td>|v + v′| where any two entries differ in sign, else |v − v′|</td>
          <td class="numeric">
            <b data-d1="published">{written(published)}</b>
          </td>
        </tr>
      </tbody>
    </table>
  );
}
