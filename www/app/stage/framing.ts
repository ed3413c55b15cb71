// Bringing a primitive to the middle of the view, and close.

import { scene } from "../state/scene";
import { selectedPrimitive, type PrimitiveRef } from "../state/selection";
import type { PointView } from "../view/point-view";
import { brushed } from "./brush";
import { labelling, labelsOf, partnersOf, segmentationOf } from "./colouring";
import { colourMode, sides } from "./display";
import { outcomes } from "./outcomes";
import { reports } from "./reports";

/** Frames a primitive, or its partner where it is not in view itself; false where there is neither. */
export function frame(view: PointView, ref: PrimitiveRef): boolean {
  const state = scene.peek();
  if (state.kind !== "ready") return false;
  const partners = partnersOf(reports.peek(), ref);
  const shown = sides.peek();
  const at = shown.includes(ref.side) ? shown.indexOf(ref.side) : shown.findIndex((side) => partners[side] !== undefined);
  const name = shown[at];
  const place = name && partners[name];
  const segmentation = name && segmentationOf(state.scene, name);
  if (!name || !segmentation || place === undefined) return false;
  const side = at === 0 ? 0 : 1;
  // The labels of some colourings tell outcomes, and a point that several primitives list has that of one of them.
  view.setLabels(side, labelsOf(segmentation, state.scene.positions.length / 3, [place]));
  view.fitLabels(side, [place + 1]);
  const now = { scene: state.scene, reports: reports.peek(), selected: selectedPrimitive.peek(), outcomes: outcomes.peek(), brushed: brushed.peek()?.points };
  view.setLabels(side, labelling(colourMode.peek(), name, now).labels);
  return true;
}
