// The lasso over the view: a curve drawn with a pointer, or a rectangle placed with keys.

import type { JSX } from "preact";
import { useSignal } from "@preact/signals";
import { useEffect, useId, useRef } from "preact/hooks";
import * as format from "../ui/format";
import type { PointView } from "../view/point-view";
import { depthOf, lassoOf } from "./lasso";
import { afterKey, cornersOf, MIDDLE, wordsFor, type Corner, type Rectangle } from "./rectangle";
import { made, making } from "./state";
import { cutAway, exactPointAt, reach } from "./tools";

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
  const size = sizeOf(view);
  if (!result || making.value || size.height === 0) return;
  const lasso = lassoOf(corners, { ...size, camera: view.camera, centre: result.centre });
  if (!lasso) return;
  const hit = view.pointsIn(0, { kind: "polygon", corners }, reach.value === "seen");
  if (hit.length === 0) return;
  if (reach.value === "through") return cutAway(lasso);
  // A little more than the deepest: what is seen must not stay for want of a digit.
  const depths = Array.from(hit, (index) => depthOf(lasso, exactPointAt(index) ?? lasso.target));
  const deepest = depths.reduce((most, depth) => Math.max(most, depth), -Infinity);
  cutAway({ ...lasso, depth: deepest + view.spacing / 4 });
}
