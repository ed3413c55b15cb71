// The explanation of a measure, one click from its column head.

import type { JSX } from "preact";
import { signal } from "@preact/signals";
import { useLayoutEffect, useRef } from "preact/hooks";
import type { Measure } from "../engine/contract";
import { protocol } from "../state/settings";
import { Icon } from "../ui/icon";
import { placeBeside } from "../ui/place";
import { Formula } from "./formula";
import { MEASURE } from "./measures";

const explained = signal<{ measure: Measure; anchor: HTMLElement } | undefined>(undefined);

/** Stands for itself beside a column head, or as the measure's name where that is all there is. */
export function ExplainButton({ measure, named = false }: { measure: Measure; named?: boolean }): JSX.Element {
  const open = explained.value?.measure === measure;
  return (
    <button
      type="button"
      class={named ? "explain named" : "explain"}
      aria-label={named ? `${measure}: what it means` : `What ${measure} means`}
      aria-expanded={open}
      onClick={(event) => {
        event.stopPropagation();
        explained.value = open ? undefined : { measure, anchor: event.currentTarget };
      }}
    >
      {named ? measure : <Icon name="help" />}
    </button>
  );
}

/** The one popover that all explanations share; stands once, at the end of the page. */
export function ExplainPopover(): JSX.Element {
  const popover = useRef<HTMLDivElement>(null);
  const current = explained.value;

  // Before the page is painted: it takes the focus, which the reader may have moved by any later time.
  useLayoutEffect(() => {
    const element = popover.current;
    if (!element) return;
    if (!current) {
      if (element.matches(":popover-open")) element.hidePopover();
      return;
    }
    element.showPopover();
    placeBeside(element, current.anchor);
    element.focus();
  }, [current]);

  return (
    <div
      ref={popover}
      popover="auto"
      class="explanation"
      role="dialog"
      aria-label={current ? `What ${current.measure} means` : "Explanation"}
      tabIndex={-1}
      onToggle={(event) => {
        if ((event as unknown as ToggleEvent).newState !== "closed") return;
        const anchor = explained.peek()?.anchor;
        explained.value = undefined;
        if (document.activeElement === document.body) anchor?.focus();
      }}
    >
      {current && <Explanation measure={current.measure} />}
    </div>
  );
}

function Explanation({ measure }: { measure: Measure }): JSX.Element {
  const { name, symbol, formula, meaning, range, better, mean, section, published } = MEASURE[measure];
  const note = protocol.value === "published" ? published : "";
  return (
    <>
      <h3>
        {measure} <span>{name}</span>
      </h3>
      <Formula symbol={symbol} formula={formula} />
      <p>{meaning}</p>
      {note && <p class="protocol-note">{note}</p>}
      <dl>
        <dt>Range</dt>
        <dd>{range}</dd>
        <dt>Good</dt>
        <dd>{better === "higher" ? "higher is better ↑" : "lower is better ↓"}</dd>
        <dt>Mean</dt>
        <dd>{mean}</dd>
        <dt>Paper</dt>
        <dd>{section}</dd>
      </dl>
    </>
  );
}
