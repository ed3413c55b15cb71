// A number that is taken over when it is complete: at Enter, at a step of the arrows, on leaving.
// One that cannot be taken is said to be so, and the field has what holds again.

import type { JSX } from "preact";
import { useSignal } from "@preact/signals";
import { useId, useLayoutEffect, useRef } from "preact/hooks";
import { integer } from "../ui/format";

interface Props {
  readonly label: string;
  /** Where the label alone would not say enough, the whole name. */
  readonly name?: string;
  /** Nothing leaves the field empty. */
  readonly value: number | undefined;
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
  const told = useId();
  /** Why what was given last was not taken. */
  const refusal = useSignal<string | undefined>(undefined);
  const shown = value === undefined ? "" : written(value);

  const restore = () => {
    if (field.current) field.current.value = shown;
    refusal.value = undefined;
  };
  // Not as a property: drawing the message anew would take back what is being typed.
  useLayoutEffect(restore, [shown]);

  const take = () => {
    const input = field.current;
    if (!input || (input.value === shown && !input.validity.badInput)) return;
    const given = input.valueAsNumber;
    if (given === value) {
      restore();
    } else if (given >= min && given <= max && (!whole || Number.isInteger(given))) {
      refusal.value = undefined;
      onValue(given);
    } else {
      const kind = whole ? "a whole number" : "a number";
      const what = input.value === "" ? "That" : input.value;
      restore();
      refusal.value = `${what} was not taken: ${name ?? label} is ${kind} from ${limit(min)} to ${limit(max)}.`;
      // Another try begins by typing over it.
      if (document.activeElement === input) input.select();
    }
  };

  return (
    <>
      <label title={hint}>
        <span>{label}</span>
        <input
          ref={field}
          type="number"
          inputMode="decimal"
          step={whole ? step : "any"}
          disabled={disabled}
          aria-label={name}
          aria-description={hint}
          aria-describedby={refusal.value && told}
          data-committed={shown}
          onChange={take}
          onInput={() => (refusal.value = undefined)}
          onKeyDown={(event) => {
            if (event.key === "Escape") {
              restore();
              return;
            }
            // With any number allowed the browser would step by one.
            const by = whole ? 0 : event.key === "ArrowUp" ? step : event.key === "ArrowDown" ? -step : 0;
            if (by === 0 || !field.current) return;
            event.preventDefault();
            const from = Number.isFinite(field.current.valueAsNumber) ? field.current.valueAsNumber : (value ?? 0);
            field.current.value = written(Math.min(max, Math.max(min, from + by)));
            take();
          }}
        />
      </label>
      {refusal.value !== undefined && (
        <p class="refusal" id={told} role="alert">
          {refusal.value}
        </p>
      )}
    </>
  );
}

/** Without the digits that binary fractions leave. */
function written(value: number): string {
  return String(Number(value.toPrecision(12)));
}

function limit(value: number): string {
  return Number.isInteger(value) ? integer(value).replace("-", "−") : String(value);
}
