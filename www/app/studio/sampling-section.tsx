// How the part becomes a cloud.

import type { JSX } from "preact";
import type { Sampling } from "./case";
import { NumberField } from "./number-field";
import { current, edit } from "./state";

interface Control {
  readonly id: keyof Sampling;
  readonly label: string;
  readonly hint: string;
  readonly min: number;
  readonly max: number;
  readonly step: number;
  readonly whole?: true;
}

/** The ranges are the engine's. */
const CONTROLS: readonly Control[] = [
  { id: "spacing", label: "Spacing", hint: "Distance between neighbouring points, over the diagonal", min: 0.0005, max: 0.1, step: 0.001 },
  { id: "noise", label: "Noise", hint: "Standard deviation of each coordinate, over the diagonal", min: 0, max: 0.1, step: 0.0005 },
  { id: "outliers", label: "Outliers", hint: "Strewn points, over the points of the part", min: 0, max: 1, step: 0.01 },
  { id: "seed", label: "Seed", hint: "The same seed gives the same points, noise and outliers", min: 0, max: 2 ** 32 - 1, step: 1, whole: true },
];

export function SamplingSection(): JSX.Element {
  const { base, sampling } = current.value;
  return (
    <section aria-labelledby="studio-sampling">
      <h3 id="studio-sampling">Sampling</h3>
      <div class="studio-fields pairs">
        {CONTROLS.map(({ id, ...control }) => (
          <NumberField
            key={id}
            {...control}
            value={sampling[id]}
            disabled={id === "spacing" && base.kind === "files"}
            onValue={(value) => edit({ sampling: { ...sampling, [id]: value } }, `Set ${control.label.toLowerCase()} to ${value}`, `sampling ${id}`)}
          />
        ))}
      </div>
    </section>
  );
}
