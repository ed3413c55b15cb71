// A range of a histogram, drawn over it: chosen by dragging over the bars, or with its two handles by keyboard.

import type { JSX, TargetedKeyboardEvent, TargetedPointerEvent } from "preact";
import "./brush.css";

/** Intervals from one bound to before another: `from` 0 to `to` 1 is the first of them. */
export interface Bins {
  readonly from: number;
  readonly to: number;
}

interface Props {
  /** What is chosen; all where nothing is. */
  readonly bins: Bins;
  readonly count: number;
  /** Room of the drawing beside its frame, in pixels. */
  readonly left: number;
  readonly right: number;
  /** What a bound is called. */
  readonly words: (bound: number) => string;
  readonly onChange: (bins: Bins) => void;
}

/** A press that moves less than this, in pixels, is a click. */
const SLOP = 4;

/** The bounds that are nearest and that lie around a place, from 0 to the number of intervals. */
function boundsAt(event: PointerEvent, box: Element, { count, left, right }: Props): { nearest: number; below: number } {
  const { x, width } = box.getBoundingClientRect();
  const share = ((event.clientX - x - left) / Math.max(1, width - left - right)) * count;
  const within = (bound: number) => Math.min(count, Math.max(0, bound));
  return { nearest: within(Math.round(share)), below: within(Math.floor(share)) };
}

/** Has a drag over the drawing choose the intervals that it goes over; a click remains one. */
export function startDrag(event: TargetedPointerEvent<HTMLElement>, props: Props): void {
  if (event.button !== 0) return;
  const box = event.currentTarget;
  const stop = new AbortController();
  const { signal } = stop;
  const start = boundsAt(event, box, props).below;
  const move = (moved: PointerEvent) => {
    if (!box.hasPointerCapture(event.pointerId)) {
      if (Math.abs(moved.clientX - event.clientX) < SLOP) return;
      // From here on the click that ends the press is that of the box, and leads nowhere.
      box.setPointerCapture(event.pointerId);
    }
    const end = boundsAt(moved, box, props).below;
    props.onChange({ from: Math.min(start, end, props.count - 1), to: Math.min(props.count, Math.max(start, end) + 1) });
  };
  box.addEventListener("pointermove", move, { signal });
  for (const end of ["pointerup", "pointercancel"]) box.addEventListener(end, () => stop.abort(), { signal });
}

export function BrushLayer(props: Props): JSX.Element {
  const { bins, count, left, right } = props;
  const at = (bound: number) => `calc(${left}px + (100% - ${left + right}px) * ${bound / count})`;
  const whole = bins.from === 0 && bins.to === count;
  return (
    <div class="brush-layer" data-whole={whole || undefined}>
      <div class="brush-range" style={{ left: at(bins.from), width: `calc((100% - ${left + right}px) * ${(bins.to - bins.from) / count})` }} />
      <Handle {...props} which="from" place={at(bins.from)} />
      <Handle {...props} which="to" place={at(bins.to)} />
    </div>
  );
}

function Handle(props: Props & { readonly which: "from" | "to"; readonly place: string }): JSX.Element {
  const { bins, count, words, which, place, onChange } = props;
  const [least, most] = which === "from" ? [0, bins.to - 1] : [bins.from + 1, count];
  const set = (bound: number) => onChange({ ...bins, [which]: Math.min(most, Math.max(least, bound)) });
  const now = bins[which];

  const key = (event: TargetedKeyboardEvent<HTMLElement>) => {
    const steps: Record<string, number> = {
      ArrowLeft: now - 1,
      ArrowDown: now - 1,
      ArrowRight: now + 1,
      ArrowUp: now + 1,
      PageDown: now - 4,
      PageUp: now + 4,
      Home: least,
      End: most,
    };
    const to = steps[event.key];
    if (to === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    set(to);
  };

  const press = (event: TargetedPointerEvent<HTMLElement>) => {
    event.stopPropagation();
    event.currentTarget.setPointerCapture(event.pointerId);
  };

  const drag = (event: TargetedPointerEvent<HTMLElement>) => {
    const box = event.currentTarget.parentElement;
    if (box && event.currentTarget.hasPointerCapture(event.pointerId)) set(boundsAt(event, box, props).nearest);
  };

  return (
    <div
      class="brush-handle"
      role="slider"
      tabIndex={0}
      aria-label={which === "from" ? "Distances from" : "Distances to"}
      aria-valuemin={least}
      aria-valuemax={most}
      aria-valuenow={now}
      aria-valuetext={words(now)}
      style={{ left: place }}
      onKeyDown={key}
      onPointerDown={press}
      onPointerMove={drag}
    />
  );
}
