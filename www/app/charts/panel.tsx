// What tables hide: how measures are spread, and where a method fails.

import type { JSX } from "preact";
import { signal, type Signal } from "@preact/signals";
import type { AccuracyMeasure } from "../engine/contract";
import { ACCURACY_MEASURES, CLASSIFICATION_MEASURES, MEASURE } from "../measures/measures";
import { rulesOf } from "../measures/protocols";
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

/** Whether the axis of each is logarithmic, once the reader has said so. */
const logarithmic = Object.fromEntries(
  ACCURACY_MEASURES.map((measure) => [measure, signal(MEASURE[measure].logarithmic)]),
) as Readonly<Record<AccuracyMeasure, Signal<boolean>>>;

export default function ChartsPanel(): JSX.Element {
  const several = models.value.length > 1;
  const scored = scoredRows.value.length > 0;
  const rules = rulesOf(protocol.value);
  return (
    <div class="charts">
      <div class="panel-tools">
        <p>
          {scored && `Measures ${rules}. Confusion, sizes and distances are those of ${chartedMethod.value}. `}
          A click on a shape goes to its model or primitive.{scored && !means.value && " With two models or more, box plots of the measures come first."}
        </p>
        {several && scored && <ScopeSwitch />}
      </div>
      <div class="chart-grid">
        {scored && (
          <>
            {means.value && <Spreads />}
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
          title={`${MEASURE[measure].name} (${measure}) over models`}
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
