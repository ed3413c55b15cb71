// The lasso over the view: a curve drawn with a pointer, or a rectangle placed with keys.

import type { JSX } from "preact";
import { useSignal } from "@preact/signals";
import { useEffect, useId, useRef } from "preact/hooks";
import * as format from "../ui/format";
import type { PointView } from "../view/point-view";
import { afterKey, cornersOf, MIDDLE, wordsFor, type Corner, type Rectangle } from "./rectangle";
import { made, making } from "./state";
import { cutAway, reach } from "./tools";

const ID = "lasso";

/** Brings up the rectangle. */
export function focusLasso(): void {
  document.getElementById(ID)?.focus();
}

/** Counting what is inside takes a look at every point: not at each step of a held key. */
const COUNT_AFTER_MS = 200;

export function LassoLayer({ view }: { view: PointView }): JSX.Element {
  const curve = useSignal<readonly Corner[]>([]);
  const rectangle = useSignal<Rectangle | undefined>(undefined);
  const pointing = useRef(false);
  const keys = useId();
  const corners = rectangle.value ? cornersOf(rectangle.value, sizeOf(view)) : curve.value;

  const key = (event: KeyboardEvent) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.key === "Escape") {
      curve.value = [];
      rectangle.value = undefined;
      return;
    }
    const before = rectangle.value ?? MIDDLE;
    const cuts = event.key === "Enter" && rectangle.value !== undefined;
    const after = event.key === "Enter" ? before : afterKey(before, event.key, event.shiftKey);
    if (!after) return;
    event.preventDefault();
    event.stopPropagation();
    rectangle.value = after;
    if (cuts) cutAlong(view, cornersOf(after, sizeOf(view)));
  };

  return (
    <div
      id={ID}
      class="lasso"
      role="application"
      tabIndex={0}
      aria-label="Lasso"
      aria-describedby={keys}
      onFocus={() => {
        if (!pointing.current) rectangle.value ??= MIDDLE;
      }}
      onKeyDown={key}
      onPointerDown={(event) => {
        if (event.button !== 0) return;
        pointing.current = true;
        rectangle.value = undefined;
        event.currentTarget.setPointerCapture(event.pointerId);
        curve.value = [[event.offsetX, event.offsetY]];
      }}
      onPointerMove={({ offsetX, offsetY }) => {
        if (curve.value.length > 0) curve.value = [...curve.value, [offsetX, offsetY]];
      }}
      onPointerUp={() => {
        const drawn = curve.value;
        curve.value = [];
        pointing.current = false;
        cutAlong(view, drawn);
      }}
      onPointerCancel={() => {
        curve.value = [];
        pointing.current = false;
      }}
      onWheel={(event) => view.zoom(Math.exp(-event.deltaY * 0.0015), event.offsetX, event.offsetY)}
    >
      <svg aria-hidden="true">
        <polygon points={corners.map((corner) => corner.join(",")).join(" ")} />
      </svg>
      <p id={keys} class="visually-hidden">
        Arrow keys move a rectangle over the view, with Shift they size it. Enter cuts what is inside, Escape takes it away.
      </p>
      {rectangle.value && <Inside view={view} rectangle={rectangle.value} />}
    </div>
  );
}

/** Where the rectangle is and what is inside, once it has come to rest. */
function Inside({ view, rectangle }: { view: PointView; rectangle: Rectangle }): JSX.Element {
  const said = useSignal("");
  const result = made.value?.result;
  const seen = reach.value === "seen";
  useEffect(() => {
    const timer = setTimeout(() => {
      const inside = view.pointsIn(0, { kind: "polygon", corners: cornersOf(rectangle, sizeOf(view)) }, seen);
      said.value = `${wordsFor(rectangle)}: ${format.plural(inside.length, "point")} inside.`;
    }, COUNT_AFTER_MS);
    return () => clearTimeout(timer);
  }, [view, rectangle, result, seen, said]);
  return (
    <p class="lasso-standing" role="status">
      {said.value}
    </p>
  );
}

/** In pixels of the page. */
function sizeOf({ canvas }: PointView): { width: number; height: number } {
  return { width: canvas.clientWidth, height: canvas.clientHeight };
}

function cutAlong(view: PointView, corners: readonly Corner[]): void {
  const result = made.value?.result;
  if (!result || making.value) return;
  const lasso = view.lasso(0, corners, reach.value === "seen");
  if (!lasso) return;
  const { centre } = result;
  const { target } = lasso;
  // The view knows places relative to the middle of the cloud.
  cutAway({ kind: "lasso", ...lasso, target: [centre[0] + target[0], centre[1] + target[1], centre[2] + target[2]] });
}
