// The reader's choice of what a table shows.

import type { JSX } from "preact";
import { MEASURES } from "../measures/measures";
import { bold, digits, isWanted, means, published, want } from "./wanted";

const DIGITS = [1, 2, 3, 4, 5, 6] as const;

export function TableOptions({ adds }: { adds: boolean }): JSX.Element {
  return (
    <div class="table-options">
      <label>
        Rows{" "}
        <select value={means.value ? "means" : "all"} onChange={({ currentTarget }) => (means.value = currentTarget.value === "means")}>
          <option value="all">all models</option>
          <option value="means">means only</option>
        </select>
      </label>
      <label>
        Digits{" "}
        <select
          value={digits.value ?? ""}
          onChange={({ currentTarget: { value } }) => (digits.value = value === "" ? undefined : Number(value))}
        >
          <option value="">as usual</option>
          {DIGITS.map((count) => (
            <option key={count} value={count}>
              {count}
            </option>
          ))}
        </select>
      </label>
      <label>
        <input type="checkbox" checked={bold.value} onChange={({ currentTarget }) => (bold.value = currentTarget.checked)} /> Best
        in bold
      </label>
      <label>
        <input type="checkbox" checked={published.value} onChange={({ currentTarget }) => (published.value = currentTarget.checked)} /> With
        the published methods
      </label>
      {published.value && !adds && (
        <p class="hint">None of the models here is one of the 35 test models, for which alone there are published figures.</p>
      )}
      <fieldset>
        <legend class="visually-hidden">Measures in the tables</legend>
        {MEASURES.map((measure) => (
          <label key={measure}>
            <input type="checkbox" checked={isWanted(measure)} onChange={({ currentTarget }) => want(measure, currentTarget.checked)} />{" "}
            {measure}
          </label>
        ))}
      </fieldset>
    </div>
  );
}
