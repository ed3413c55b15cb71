// What a data set holds: types of surfaces, sizes, and what no primitive lists.

import type { JSX } from "preact";
import { useEffect } from "preact/hooks";
import type { DatasetStatistics } from "../engine/contract";
import { models } from "../state/models";
import * as format from "../ui/format";
import { Icon } from "../ui/icon";
import { ModelsTable } from "./models-table";
import { SpreadChart, type Figure } from "./spread-chart";
import { countAgain, counts, follow, sums, uncounted } from "./state";
import { TypeBars } from "./type-bars";
import "./statistics.css";

const FIGURES: readonly Figure[] = [
  {
    id: "points-per-model",
    title: "Points per model",
    axis: "Points →",
    of: ({ statistics }) => statistics.points,
    spread: ({ pointsPerModel }) => pointsPerModel,
    write: format.integer,
    tick: format.shortCount,
  },
  {
    id: "primitives-per-model",
    title: "Primitives per model",
    axis: "Primitives →",
    of: ({ statistics }) => (statistics.segmented === undefined ? undefined : statistics.primitives),
    spread: ({ primitivesPerModel }) => primitivesPerModel,
    write: format.integer,
    tick: "d",
  },
  {
    id: "unsegmented-per-model",
    title: "Points that no primitive lists",
    axis: "Share of the model's points →",
    of: ({ statistics }) => statistics.unsegmented,
    spread: ({ unsegmentedPerModel }) => unsegmentedPerModel,
    write: format.share,
    tick: "~%",
  },
];

export default function Statistics(): JSX.Element {
  useEffect(follow, []);
  const progress = counts.progress.value;
  const known = sums.value;
  const several = (known?.sets.length ?? 0) > 1;
  return (
    <div class="statistics">
      <header>
        <h2>Dataset statistics</h2>
        <p role="status">
          {known && summaryOf(known.all)}
          {uncounted.value.length > 0 && `; ${format.plural(uncounted.value.length, "model")} could not be counted`}
        </p>
        {progress && <progress aria-label="Models counted" value={progress.done} max={progress.total} />}
      </header>
      <Uncounted />
      {known && known.all.models > 0 ? (
        <>
          <div class="chart-grid">
            {known.sets
              .filter(({ statistics }) => statistics.primitives > 0)
              .map((set) => (
                <TypeBars key={set.name} set={set} only={!several} />
              ))}
            {FIGURES.map((figure) => (
              <SpreadChart key={figure.id} figure={figure} models={known.models} sets={known.sets} />
            ))}
          </div>
          <div class="statistics-table" role="region" aria-label="Models" tabIndex={0}>
            <ModelsTable models={known.models} all={known.all} several={several} />
          </div>
        </>
      ) : (
        <p class="empty">{progress ? "Counting…" : models.value.length > 0 ? "There is nothing to show." : "Drop a set of models anywhere on the page to count what it holds."}</p>
      )}
    </div>
  );
}

/** Sums without some of the models must not look like sums of all. */
function Uncounted(): JSX.Element | null {
  const lacking = uncounted.value;
  if (lacking.length === 0) return null;
  return (
    <details class="uncounted">
      <summary>
        <Icon name="error" /> Why {format.plural(lacking.length, "model")} of {format.integer(models.value.length)} could not be counted and{" "}
        {lacking.length === 1 ? "is" : "are"} left out
      </summary>
      <ul>
        {lacking.map(({ id, reason }) => (
          <li key={id}>
            <strong>{id}</strong> {reason}
          </li>
        ))}
      </ul>
      <button type="button" onClick={countAgain}>
        Try again
      </button>
    </details>
  );
}

function summaryOf(all: DatasetStatistics): string {
  const share = all.unsegmented;
  const unsegmented = share === null ? "" : share === 0 ? ", every point in a primitive" : `, ${format.share(share)} of the points in no primitive`;
  return `${format.plural(all.models, "model")}, ${format.plural(all.points, "point")}, ${format.plural(all.primitives, "true primitive")}${unsegmented}`;
}
