// What of the table is shown: the models it is about, and the figures.

import type { JSX } from "preact";
import { Choice } from "../ui/choice";
import { VIEWS } from "./columns";
import { showSet, showView, shownSet, view } from "./state";
import { SETS } from "./table-data";

export function SetChoice(): JSX.Element {
  return (
    <label>
      On{" "}
      <select value={shownSet.value} onChange={(event) => showSet(event.currentTarget.value)}>
        {SETS.map(({ id, title, models }) => (
          <option key={id} value={id}>
            {title} ({models.length})
          </option>
        ))}
      </select>
    </label>
  );
}

/** A method's page has no figures of several sets side by side. */
export function ViewChoice({ forMethod = false }: { forMethod?: boolean }): JSX.Element {
  const offered = VIEWS.filter(({ figures }) => !forMethod || figures.length > 0);
  const value = offered.find(({ name }) => name === view.value)?.name ?? offered[0]?.name ?? view.value;
  return <Choice label="Figures" value={value} options={offered.map(({ name, title }) => [name, title])} onChange={showView} />;
}
