// The table itself with what belongs to it: what the set is, accuracy against time, and two methods compared.

import type { JSX } from "preact";
import { signal } from "@preact/signals";
import { plural } from "../ui/format";
import type { Sorting } from "../ui/table";
import { ALL_FIGURES, VIEWS } from "./columns";
import { PairSection } from "./pair";
import { TimePlot } from "./plot";
import { StandingTable } from "./standing";
import { showMethod, shownSet, view } from "./state";
import { ROWS, setOf, SETS, summaryOf } from "./table-data";

const sorting = signal<Sorting | undefined>(undefined);
/** The figure that is set against time, and followed from clean to degraded data. */
const figureKey = signal(ALL_FIGURES[0]?.key ?? "");

export function Standing(): JSX.Element {
  const set = setOf(shownSet.value);
  const shown = VIEWS.find(({ name }) => name === view.value) ?? VIEWS[0];
  const one = ALL_FIGURES.find(({ key }) => key === figureKey.value) ?? ALL_FIGURES[0];
  if (!set || !shown || !one) return <p class="empty">The table is empty.</p>;
  const rows = ROWS.filter((row) => summaryOf(row, set.id) !== undefined);
  return (
    <>
      <p class="results-note">{set.meaning}</p>
      {rows.length === 0 && <p class="empty">Nothing was scored on these models yet.</p>}
      {rows.length > 0 && <Shown />}
      {shown.name !== "wear" && <PairSection set={set.id} view={shown} />}
      {rows.length > 0 && (
        <div class="chart-grid">
          <div class="wide">
            <FigureChoice />
            <TimePlot rows={rows} set={set.id} figure={one} />
          </div>
        </div>
      )}
      <Foot />
    </>
  );
}

/** Which one figure is meant where one alone is shown. */
function FigureChoice(): JSX.Element {
  return (
    <label>
      Figure{" "}
      <select value={figureKey.value} onChange={(event) => (figureKey.value = event.currentTarget.value)}>
        {ALL_FIGURES.map(({ key, title }) => (
          <option key={key} value={key}>
            {title}
          </option>
        ))}
      </select>
    </label>
  );
}

/** The table of the view that was chosen. */
export function Shown(): JSX.Element | null {
  const set = setOf(shownSet.value);
  const shown = VIEWS.find(({ name }) => name === view.value) ?? VIEWS[0];
  const one = ALL_FIGURES.find(({ key }) => key === figureKey.value) ?? ALL_FIGURES[0];
  if (!set || !shown || !one) return null;
  const base = set.of ?? set.id;
  const family = SETS.filter(({ id, of }) => id === base || of === base);
  const columns =
    shown.figures.length > 0
      ? shown.figures.map((figure) => ({ figure, set: set.id, head: figure.title }))
      : family.map(({ id, title }) => ({ figure: one, set: id, head: `${one.title}: ${title.split(", ")[1] ?? "clean"}` }));
  const rows = ROWS.filter((row) => columns.some((column) => summaryOf(row, column.set) !== undefined));
  const isOfOne = shown.figures.length > 0;
  return (
    <div class="results-scroll" role="region" aria-label="Standing table" tabIndex={0}>
      <StandingTable
        caption={
          <>
            {isOfOne ? `${set.title}: mean over ${plural(set.models.length, "model")}` : `${one.title}, mean over ${plural(set.models.length, "model")} each`}, and below it its
            bootstrap 95 % interval. The best is bold.
          </>
        }
        rows={rows}
        columns={columns}
        set={set.id}
        sorting={sorting}
        onOpen={({ id }) => showMethod(id)}
      />
    </div>
  );
}

function Foot(): JSX.Element {
  return (
    <p class="results-note">
      A new row is a folder with two files, written by <code>fit4cad submit</code> and scored again by the project before it is taken in; nobody
      writes a figure by hand. {import.meta.env.PROD && <a href="./results/feed.json">What changes, as a JSON feed</a>}
    </p>
  );
}
