// Where the views are cut: beside them and beside the cross-section.

import type { JSX } from "preact";
import { cutAcross, cutAt, CUTS } from "./display";

/** The axis to cut across. */
export function CutAxis(): JSX.Element {
  return (
    <select value={cutAcross.value} onChange={(event) => (cutAcross.value = event.currentTarget.value as typeof cutAcross.value)}>
      {CUTS.map(({ id, title }) => (
        <option key={id} value={id}>
          {title}
        </option>
      ))}
    </select>
  );
}

/** How far along that axis. */
export function CutPlace(): JSX.Element {
  return <input type="range" min={0} max={1} step={0.005} value={cutAt.value} onInput={(event) => (cutAt.value = event.currentTarget.valueAsNumber)} />;
}
