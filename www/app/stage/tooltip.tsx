// What is under the cursor.

import type { JSX } from "preact";
import type { ModelScene } from "../../worker/protocol";
import type { SurfaceInfo } from "../engine/contract";
import { scene } from "../state/scene";
import type { Side as SideName } from "../state/selection";
import type { Hit } from "../view/types";
import { drawingOrder, members, segmentationOf } from "./colouring";
import { sides } from "./display";
import { reports } from "./reports";

export interface Pointed {
  readonly hit: Hit;
  readonly x: number;
  readonly y: number;
}

interface Found {
  readonly side: SideName;
  readonly place: number;
  readonly distance: number;
}

/** The primitive that is seen at a point, on the side where it was pointed at. */
export function primitiveAt({ side: view, index }: Hit): Found | undefined {
  const state = scene.peek();
  if (state.kind !== "ready") return undefined;
  const side = sides.peek()[view];
  const segmentation = segmentationOf(state.scene, side);
  if (!segmentation) return undefined;
  const order = drawingOrder(side, reports.peek(), segmentation);
  const place = order.findLast((each) => members(segmentation, each).includes(index));
  if (place === undefined) return undefined;
  const at = (segmentation.offsets[place] ?? 0) + members(segmentation, place).indexOf(index);
  return { side, place, distance: segmentation.distances[at] ?? NaN };
}

/** A primitive in words: `True 3: Plane`. */
export function wordsFor(scene: ModelScene, side: SideName, place: number): string | undefined {
  const primitive = segmentationOf(scene, side)?.primitives[place];
  const whose = { truth: "True", prediction: "Predicted", rival: scene.rival?.method }[side];
  return primitive && `${whose} ${primitive.number}: ${primitive.type ?? "other"}`;
}

export function Tooltip({ hit, x, y }: Pointed): JSX.Element {
  const found = primitiveAt(hit);
  const state = scene.value;
  const shown = found && state.kind === "ready" ? state.scene : undefined;
  const primitive = found && shown && segmentationOf(shown, found.side)?.primitives[found.place];
  return (
    <div class="tooltip" style={{ left: `${x}px`, top: `${y}px` }}>
      {primitive ? (
        <>
          <strong>{wordsFor(shown, found.side, found.place)}</strong>
          {primitive.surface && <span>{parameters(primitive.surface)}</span>}
          {!Number.isNaN(found.distance) && <span>distance {significant(found.distance)}</span>}
        </>
      ) : (
        <strong>Unsegmented</strong>
      )}
      <span>point {shownNumber(hit.index)}</span>
    </div>
  );
}

/** The number that files give a point. */
function shownNumber(index: number): number {
  const state = scene.value;
  return (state.kind === "ready" ? state.scene.numbers?.[index] : undefined) ?? index + 1;
}

function significant(value: number): string {
  return Number(value.toPrecision(4)).toString();
}

function vector(components: readonly number[]): string {
  return `(${components.map(significant).join(", ")})`;
}

function parameters(surface: SurfaceInfo): string {
  switch (surface.type) {
    case "Plane":
      return `normal ${vector(surface.normal)}, offset ${significant(surface.offset)}`;
    case "Cylinder":
      return `radius ${significant(surface.radius)}, axis ${vector(surface.axis)}`;
    case "Cone":
      return `half-angle ${significant((surface.halfAngle * 180) / Math.PI)}°, axis ${vector(surface.axis)}`;
    case "Sphere":
      return `radius ${significant(surface.radius)}, centre ${vector(surface.centre)}`;
    case "Torus":
      return `radii ${significant(surface.majorRadius)} and ${significant(surface.minorRadius)}, axis ${vector(surface.axis)}`;
  }
}
