// A task that the page checks as the reader works on it.

import type { ComponentChildren, JSX } from "preact";
import { useSignal } from "@preact/signals";
import { Icon } from "../ui/icon";

interface Props {
  readonly task: ComponentChildren;
  /** Undefined while there is nothing to check. */
  readonly solved: boolean | undefined;
  /** Where the reader stands, in the figures of the task. */
  readonly standing: ComponentChildren;
  readonly hint: ComponentChildren;
  /** Said once it is solved. */
  readonly learnt: ComponentChildren;
}

export function Exercise({ task, solved, standing, hint, learnt }: Props): JSX.Element {
  const hinted = useSignal(false);
  return (
    <section class="exercise" data-solved={solved === true} aria-label="Exercise">
      <h3>Exercise</h3>
      <p>{task}</p>
      <p class="standing" role="status">
        {solved === true ? (
          <strong class="solved">
            <Icon name="check" /> Solved.
          </strong>
        ) : (
          <strong>Not yet.</strong>
        )}{" "}
        {standing}
      </p>
      {solved === true ? (
        <p>{learnt}</p>
      ) : (
        <>
          <button type="button" aria-expanded={hinted.value} onClick={() => (hinted.value = !hinted.value)}>
            Hint
          </button>
          {hinted.value && <p class="hint">{hint}</p>}
        </>
      )}
    </section>
  );
}
