// What tables hide: how measures are spread, and where a method fails.

import type { JSX } from "preact";
import { signal } from "@preact/signals";
import { CLASSIFICATION_MEASURES, ACCURACY_MEASURES, MEASURE_TEXT } from "../measures/measures";
import { means } from "../scores/means";
import { models, scoredRows } from "../state/models";
import { selectedModel } from "../state/selection";
import { protocol } from "../state/settings";
import { ConfusionChart } from "./confusion";
import { DistanceChart } from "./distances";
import { chartedMethod, scope } from "./scope";
import { SizeChart } from "./size";
import { SpreadChart } from "./spread";
import { TypesChart } from "./types";

/** Distances of coefficients range over orders of magnitude, the others seldom do. */
const logarithmic = { MFE: signal(false), dHaus: signal(false), d1: signal(true) };

export default function ChartsPanel(): JSX.Element {
  const several = models.value.length > 1;
  const scored = scoredRows.value.length > 0;
  const rules = protocol.value === "published" ? "as the published tables were made" : "by definition";
  return (
    <div class="charts">
      <div class="panel-tools">
        <p>
          {scored && `Measures ${rules}. Confusion, sizes and distances are those of ${chartedMethod.value}. `}
          A click on a shape goes to its model or primitive.
        </p>
        {several && scored && <ScopeSwitch />}
      </div>
      <div class="chart-grid">
        {scored && (
          <>
            {means.value ? <Spreads /> : <p class="empty wide">Box plots need two scored models or more.</p>}
            <TypesChart />
            <ConfusionChart />
            <SizeChart />
          </>
        )}
        <DistanceChart />
      </div>
    </div>
  );
}

function Spreads(): JSX.Element {
  return (
    <>
      <div class="wide">
        <SpreadChart name="classification" title="Classification measures over models" measures={CLASSIFICATION_MEASURES} />
      </div>
      {ACCURACY_MEASURES.map((measure) => (
        <SpreadChart
          key={measure}
          name={measure}
          title={`${MEASURE_TEXT[measure].name} (${measure}) over models`}
          measures={[measure]}
          logarithmic={logarithmic[measure]}
        />
      ))}
    </>
  );
}

function ScopeSwitch(): JSX.Element {
  return (
    <fieldset class="switch">
      <legend class="visually-hidden">Models in the charts of primitives</legend>
      <label>
        <input type="radio" name="chart-scope" checked={scope.value === "all"} onChange={() => (scope.value = "all")} />
        <span>All models</span>
      </label>
      <label>
        <input type="radio" name="chart-scope" checked={scope.value === "one"} onChange={() => (scope.value = "one")} />
        <span>Only {selectedModel.value}</span>
      </label>
    </fieldset>
  );
}
