// Choose a part and how it is sampled.

import type { JSX } from "preact";
import { useSignal } from "@preact/signals";
import { PARTS } from "../../generated/declared/parts.js";
import { SAMPLE_OPTIONS } from "../../generated/declared/sample-options.js";
import type { SampleOptions } from "../engine/contract";
import { capitalised } from "../ui/format";
import { makeSample } from "./samples";

export function SampleForm({ onMade }: { onMade: () => void }): JSX.Element {
  const options = useSignal<SampleOptions>({});
  return (
    <form class="samples" onSubmit={(event) => event.preventDefault()}>
      <p>Each has a true ground truth and a submission that is imperfect on purpose, so that there is something to score.</p>
      <div class="controls">
        {SAMPLE_OPTIONS.map(({ name, unit, minimum, maximum, default: initial, whole, explanation }) => (
          <label key={name} title={unit === "" ? explanation : `${explanation} ${capitalised(unit)}.`}>
            {capitalised(name)}
            <input
              type="number"
              inputMode="decimal"
              min={minimum}
              max={maximum}
              step={whole ? 1 : "any"}
              placeholder={String(initial)}
              aria-description={explanation}
              onInput={(event) => {
                const { [name]: _, ...others } = options.value;
                const value = event.currentTarget.valueAsNumber;
                options.value = Number.isFinite(value) ? { ...others, [name]: value } : others;
              }}
            />
          </label>
        ))}
      </div>
      <ul class="parts">
        {PARTS.map(({ name, title, description }) => (
          <li key={name}>
            <button
              type="button"
              onClick={(event) => {
                if (!event.currentTarget.form?.reportValidity()) return;
                onMade();
                void makeSample(name, options.value);
              }}
            >
              <strong>{title}</strong>
              <span>{description}</span>
            </button>
          </li>
        ))}
      </ul>
    </form>
  );
}
