// Where to look from: a choice that acts and forgets.

import type { JSX } from "preact";
import type { PointView } from "./point-view";
import { STANDPOINTS } from "./types";

/** Nothing can be chosen while there is no view. */
export function LookFrom({ view }: { view: PointView | undefined }): JSX.Element {
  return (
    <label>
      <span class="visually-hidden">Look from</span>
      <select
        value=""
        disabled={!view}
        onChange={(event) => {
          const chosen = STANDPOINTS.find(({ name }) => name === event.currentTarget.value);
          if (chosen) view?.lookFrom(chosen.standpoint);
          event.currentTarget.value = "";
        }}
      >
        <option value="">Look from…</option>
        {STANDPOINTS.map(({ name }) => (
          <option key={name} value={name}>
            {name}
          </option>
        ))}
      </select>
    </label>
  );
}
