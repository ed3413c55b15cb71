// A number that is taken over when it is complete: at Enter, at a step of the arrows, on leaving.

import type { JSX } from "preact";
import { useRef } from "preact/hooks";

interface Props {
  readonly label: string;
  /** Where the label alone would not say enough, the whole name. */
  readonly name?: string;
  readonly value: number;
  readonly min?: number;
  readonly max?: number;
  readonly step?: number;
  readonly whole?: boolean;
  readonly disabled?: boolean;
  readonly hint?: string | undefined;
  readonly onValue: (value: number) => void;
}

export function NumberField(props: Props): JSX.Element {
  const { label, name, value, min = -1e6, max = 1e6, step = 1, whole = false, disabled = false, hint, onValue } = props;
  const field = useRef<HTMLInputElement>(null);
  const shown = String(Number(value.toPrecision(10)));

  const take = () => {
    const input = field.current;
    if (!input || input.value === shown) return;
    const given = input.valueAsNumber;
    const right = given >= min && given <= max && (!whole || Number.isInteger(given));
    const kind = whole ? "a whole number" : "a number";
    input.setCustomValidity(right ? "" : `${name ?? label} is ${kind} from ${min} to ${max}.`);
    if (right) onValue(given);
    else input.reportValidity();
  };

  return (
    <label title={hint}>
      <span>{label}</span>
      <input
        ref={field}
        type="number"
        inputMode="decimal"
        step={whole ? step : "any"}
        value={shown}
        disabled={disabled}
        aria-label={name}
        aria-description={hint}
        data-committed={shown}
        onChange={take}
        onKeyDown={(event) => {
          // With any number allowed the browser would step by one.
          const by = whole ? 0 : event.key === "ArrowUp" ? step : event.key === "ArrowDown" ? -step : 0;
          if (by === 0 || !field.current) return;
          event.preventDefault();
          const next = Math.min(max, Math.max(min, (Number.isFinite(field.current.valueAsNumber) ? field.current.valueAsNumber : value) + by));
          field.current.value = String(Number(next.toPrecision(10)));
          take();
        }}
        onInput={(event) => event.currentTarget.setCustomValidity("")}
      />
    </label>
  );
}
