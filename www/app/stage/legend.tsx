// What the colours mean, where they mean more than which primitive.

import type { JSX } from "preact";
import { computed } from "@preact/signals";
import { scene } from "../state/scene";
import { selectedPrimitive, selectedReports } from "../state/selection";
import { protocol } from "../state/settings";
import { sample, SEQUENTIAL } from "../view/palette";
import { labelling, largestDistance } from "./colouring";
import { colourMode } from "./display";

const STEPS = 12;

const legend = computed(() => {
  const state = scene.value;
  if (state.kind !== "ready") return undefined;
  const report = selectedReports.value?.[protocol.value];
  return labelling(colourMode.value, 1, { scene: state.scene, report, selected: undefined }).legend;
});

export function Legend(): JSX.Element | null {
  const state = scene.value;
  if (colourMode.value === "distance" && state.kind === "ready") {
    return (
      <div class="legend">
        <span>0</span>
        <span class="scale" aria-hidden="true">
          {Array.from({ length: STEPS }, (_, step) => (
            <i key={step} style={{ backgroundColor: sample(SEQUENTIAL, step / (STEPS - 1)) }} />
          ))}
        </span>
        <span>{Number(largestDistance(state.scene).toPrecision(3))} units of the file</span>
      </div>
    );
  }
  if (colourMode.value === "outcome" && !selectedPrimitive.value) {
    return <p class="legend">Select a primitive in the view or the table.</p>;
  }
  if (!legend.value) return null;
  return (
    <ul class="legend">
      {legend.value.map(({ colour, text }) => (
        <li key={text}>
          <span class="swatch" style={{ backgroundColor: colour }} />
          {text}
        </li>
      ))}
    </ul>
  );
}
