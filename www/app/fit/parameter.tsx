// One parameter: value, unit, range, default, what it does, and the way back.

import type { JSX } from "preact";
import { useId } from "preact/hooks";
import type { ParameterInfo } from "../engine/contract";
import { capitalised } from "../ui/format";

interface Props {
  readonly info: ParameterInfo;
  /** Undefined where the default holds. */
  readonly value: number | undefined;
  readonly onChange: (value: number | undefined) => void;
}

/** `fuzzy_border` as words. */
export function title(name: string): string {
  return capitalised(name.replaceAll("_", " "));
}

export function Parameter({ info, value, onChange }: Props): JSX.Element {
  const id = useId();
  const { name, unit, minimum, maximum, whole, explanation } = info;
  return (
    <div class="parameter" data-changed={value !== undefined || undefined}>
      <label for={id}>{title(name)}</label>
      <span class="value">
        <input
          id={id}
          type="number"
          inputMode={whole ? "numeric" : "decimal"}
          required
          min={minimum}
          max={maximum}
          step={whole ? 1 : "any"}
          value={value ?? info.default}
          aria-describedby={`${id}-about`}
          onInput={({ currentTarget }) => {
            if (!currentTarget.validity.valid) return;
            const entered = currentTarget.valueAsNumber;
            onChange(entered === info.default ? undefined : entered);
          }}
        />
        {unit && <span class="unit">{unit}</span>}
      </span>
      <button
        type="button"
        class="link"
        disabled={value === undefined}
        aria-label={`Reset ${title(name)} to ${info.default}`}
        onClick={() => onChange(undefined)}
      >
        Reset
      </button>
      <p id={`${id}-about`}>
        {explanation}{" "}
        <span class="range">
          {minimum.toLocaleString("en")} to {maximum.toLocaleString("en")}
          {whole ? ", whole" : ""}; default {info.default}.
        </span>
      </p>
    </div>
  );
}
