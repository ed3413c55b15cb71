// The border between the views and the panels: dragged, or moved by the arrow keys.

import type { JSX } from "preact";
import { signal } from "@preact/signals";

/** Share of the height that the views have, in per cent. */
export const viewsShare = signal(64);

const LEAST = 20;
const MOST = 85;
const STEP = 5;

function move(to: number): void {
  viewsShare.value = Math.round(Math.min(MOST, Math.max(LEAST, to)));
}

export function Splitter(): JSX.Element {
  return (
    <div
      class="splitter"
      role="separator"
      tabIndex={0}
      aria-label="Height of the views"
      aria-orientation="horizontal"
      aria-valuemin={LEAST}
      aria-valuemax={MOST}
      aria-valuenow={viewsShare.value}
      onPointerDown={(event) => event.currentTarget.setPointerCapture(event.pointerId)}
      onPointerMove={(event) => {
        if (!event.currentTarget.hasPointerCapture(event.pointerId)) return;
        const around = event.currentTarget.parentElement?.getBoundingClientRect();
        if (around && around.height > 0) move((100 * (event.clientY - around.top)) / around.height);
      }}
      onKeyDown={(event) => {
        const to = { ArrowUp: viewsShare.value - STEP, ArrowDown: viewsShare.value + STEP, Home: LEAST, End: MOST }[event.key];
        if (to === undefined) return;
        event.preventDefault();
        move(to);
      }}
    />
  );
}
