// `?embed=results`: the standing table to look at, for course and project pages.

import type { JSX } from "preact";
import { useEffect } from "preact/hooks";
import { ExplainPopover } from "../measures/explain";
import { SetChoice, ViewChoice } from "./choices";
import { MethodPage } from "./method";
import { Shown } from "./overview";
import { heedAddress, shownMethod, shownSet } from "./state";
import { rowOf, SETS } from "./table-data";
import "./results.css";

export default function EmbeddedResults(): JSX.Element {
  useEffect(heedAddress, []);
  const row = rowOf(shownMethod.value);
  return (
    <div class="embed results-embed">
      <header class="bar">
        <h1 class="brand">
          Fit4CAD <span>Results</span>
        </h1>
        <a href={fullAddress()} target="_blank" rel="noopener">
          Open full
        </a>
      </header>
      <main class="results-page">
        <div class="panel-tools">
          <SetChoice />
          <ViewChoice forMethod={row !== undefined} />
        </div>
        {row ? <MethodPage key={row.id} row={row} /> : <Shown />}
      </main>
      <ExplainPopover />
    </div>
  );
}

/** The same on the page itself. */
function fullAddress(): string {
  const query = new URLSearchParams({ page: "results" });
  if (shownMethod.value !== undefined) query.set("method", shownMethod.value);
  if (shownSet.value !== SETS[0]?.id) query.set("set", shownSet.value);
  return `${location.pathname}?${query}`;
}
