// Choose a part and how it is sampled.

import type { JSX } from "preact";
import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import type { SampleOptions } from "../engine/contract";
import { listParts, makeSample, partList } from "./samples";

interface Control {
  readonly id: keyof SampleOptions;
  readonly label: string;
  readonly explanation: string;
  readonly min: number;
  readonly max: number;
  readonly step: number;
}

const CONTROLS: readonly Control[] = [
  { id: "spacing", label: "Spacing", explanation: "distance between points, over the part's diagonal; empty for the part's own", min: 0.001, max: 0.05, step: 0.0005 },
  { id: "noise", label: "Noise", explanation: "standard deviation along the normal, over the diagonal", min: 0, max: 0.02, step: 0.0005 },
  { id: "outliers", label: "Outliers", explanation: "share of points strewn through the bounding box", min: 0, max: 0.3, step: 0.01 },
  { id: "missing", label: "Missing", explanation: "share of points cut away", min: 0, max: 0.5, step: 0.05 },
  { id: "seed", label: "Seed", explanation: "another seed, another sample; the same seed, the same sample", min: 0, max: 999999, step: 1 },
];

export function SampleForm({ onMade }: { onMade: () => void }): JSX.Element {
  useEffect(() => void listParts(), []);
  const options = useSignal<SampleOptions>({});
  return (
    <form class="samples" onSubmit={(event) => event.preventDefault()}>
      <p>Each has a true ground truth and a submission that is imperfect on purpose, so that there is something to score.</p>
      <div class="controls">
        {CONTROLS.map(({ id, label, explanation, min, max, step }) => (
          <label key={id} title={explanation}>
            {label}
            <input
              type="number"
              inputMode="decimal"
              min={min}
              max={max}
              step={step}
              placeholder={id === "spacing" ? "auto" : id === "seed" ? "1" : "0"}
              aria-description={explanation}
              onInput={(event) => {
                const { [id]: _, ...others } = options.value;
                const value = event.currentTarget.valueAsNumber;
                options.value = Number.isFinite(value) ? { ...others, [id]: value } : others;
              }}
            />
          </label>
        ))}
      </div>
      <ul class="parts">
        {partList.value.map(({ name, title, description }) => (
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
