// How the part becomes a cloud.

import type { JSX } from "preact";
import { SAMPLE_OPTIONS } from "../../generated/declared/sample-options.js";
import { capitalised } from "../ui/format";
import type { Sampling } from "./case";
import { NumberField } from "./number-field";
import { current, edit } from "./state";

/** By how much the arrows change each. */
const STEPS: Readonly<Record<keyof Sampling, number>> = { spacing: 0.001, noise: 0.0005, outliers: 0.01, seed: 1 };

export function SamplingSection(): JSX.Element {
  const { base, sampling } = current.value;
  return (
    <section aria-labelledby="studio-sampling">
      <h3 id="studio-sampling">Sampling</h3>
      <div class="studio-fields pairs">
        {SAMPLE_OPTIONS.flatMap(({ name, unit, minimum, maximum, whole, explanation }) => {
          // What is missing is cut away piece by piece, below.
          if (name === "missing") return [];
          return (
            <NumberField
              key={name}
              label={capitalised(name)}
              hint={unit === "" ? explanation : `${explanation} ${capitalised(unit)}.`}
              min={minimum}
              max={maximum}
              step={STEPS[name]}
              whole={whole}
              value={sampling[name]}
              disabled={name === "spacing" && base.kind === "files"}
              onValue={(value) => edit({ sampling: { ...sampling, [name]: value } }, `Set ${name} to ${value}`, `sampling ${name}`)}
            />
          );
        })}
      </div>
    </section>
  );
}
