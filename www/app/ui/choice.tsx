// A few choices side by side, with their name before them.

import type { JSX } from "preact";
import { useId } from "preact/hooks";
import { Swatch } from "./swatch";

interface ChoiceProps<T extends string> {
  readonly label: string;
  readonly value: T;
  readonly options: readonly (readonly [T, string])[];
  readonly swatch?: (value: T) => string;
  readonly onChange: (value: T) => void;
}

export function Choice<T extends string>({ label, value, options, swatch, onChange }: ChoiceProps<T>): JSX.Element {
  const group = useId();
  return (
    <fieldset class="switch">
      <legend>{label}</legend>
      {options.map(([each, name]) => (
        <label key={each}>
          <input type="radio" name={group} checked={each === value} onChange={() => onChange(each)} />
          <span>
            {swatch && <Swatch colour={swatch(each)} />}
            {name}
          </span>
        </label>
      ))}
    </fieldset>
  );
}
