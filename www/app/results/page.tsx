// The standing table: who is where, how certainly, and at what cost.

import type { JSX } from "preact";
import { useEffect } from "preact/hooks";
import { MethodPage } from "./method";
import { heedAddress, showMethod, shownMethod } from "./state";
import { Standing } from "./overview";
import { rowOf } from "./table-data";
import { SetChoice, ViewChoice } from "./choices";
import "./results.css";

export default function Results(): JSX.Element {
  useEffect(heedAddress, []);
  const asked = shownMethod.value;
  const row = rowOf(asked);
  return (
    <div class="results-page">
      <header>
        <h2>Results</h2>
        <p>
          Methods on the benchmark’s public models, every figure computed anew by this page’s engine from answers that are known by
          their SHA-256. A row opens its method, where every digit can be checked.
        </p>
      </header>
      <div class="panel-tools">
        <SetChoice />
        <ViewChoice forMethod={row !== undefined} />
      </div>
      {asked !== undefined && !row && (
        <p class="empty" role="alert">
          There is no method “{asked}” in the table.{" "}
          <button type="button" class="link" onClick={() => showMethod(undefined)}>
            All methods
          </button>
        </p>
      )}
      {row ? <MethodPage key={row.id} row={row} /> : <Standing />}
    </div>
  );
}
