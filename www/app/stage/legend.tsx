// What the colours mean, where they mean more than which primitive.

import type { JSX } from "preact";
import { scene } from "../state/scene";
import { selectedPrimitive } from "../state/selection";
import { sample, SEQUENTIAL } from "../view/palette";
import { endOfScale } from "./colouring";
import { colourMode } from "./display";
import { fixedKey } from "./key";

const STEPS = 12;

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
        <span>{endOfScale(state.scene)}</span>
      </div>
    );
  }
  if (colourMode.value === "outcome" && !selectedPrimitive.value) {
    return <p class="legend">Select a primitive in the view or the table.</p>;
  }
  const entries = state.kind === "ready" ? fixedKey(colourMode.value) : [];
  if (entries.length === 0) return null;
  return (
    <ul class="legend">
      {entries.map(({ colour, text }) => (
        <li key={text}>
          <span class="swatch" style={{ backgroundColor: colour }} />
          {text}
        </li>
      ))}
    </ul>
  );
}
