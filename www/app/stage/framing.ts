// Bringing a primitive to the middle of the view, and close.

import { scene } from "../state/scene";
import type { PrimitiveRef } from "../state/selection";
import type { PointView } from "../view/point-view";
import type { ClipBox } from "../view/types";
import { members, partnersOf, segmentationOf } from "./colouring";
import { sides } from "./display";
import { reports } from "./reports";

const AXES = [0, 1, 2] as const;

/** Frames a primitive, or its partner where it is not in view itself; false where there is neither. */
export function frame(view: PointView, ref: PrimitiveRef): boolean {
  const state = scene.peek();
  if (state.kind !== "ready") return false;
  const partners = partnersOf(reports.peek(), ref);
  const shown = sides.peek();
  const name = shown.includes(ref.side) ? ref.side : shown.find((side) => partners[side] !== undefined);
  const place = name && partners[name];
  const segmentation = name && segmentationOf(state.scene, name);
  if (!name || !segmentation || place === undefined) return false;
  view.fitBox(boxOf(state.scene.positions, members(segmentation, place)));
  return true;
}

/** The box around some points; those that are not finite do not count. */
function boxOf(positions: Float32Array, indices: Uint32Array): ClipBox {
  const low: [number, number, number] = [Infinity, Infinity, Infinity];
  const high: [number, number, number] = [-Infinity, -Infinity, -Infinity];
  for (const index of indices) {
    for (const axis of AXES) {
      const value = positions[3 * index + axis] ?? NaN;
      if (!Number.isFinite(value)) continue;
      if (value < low[axis]) low[axis] = value;
      if (value > high[axis]) high[axis] = value;
    }
  }
  return { low, high };
}
