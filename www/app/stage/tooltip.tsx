// What is under the cursor.

import type { JSX } from "preact";
import type { SurfaceInfo } from "../engine/contract";
import { scene } from "../state/scene";
import type { Side as SideName } from "../state/selection";
import type { Hit } from "../view/types";

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

/** The first primitive that lists the point, on the side where it was pointed at. */
export function primitiveAt({ side, index }: Hit): Found | undefined {
  const state = scene.peek();
  if (state.kind !== "ready") return undefined;
  const segmentation = side === 0 ? state.scene.truth : state.scene.prediction;
  if (!segmentation) return undefined;
  const at = segmentation.indices.indexOf(index);
  if (at < 0) return undefined;
  const place = segmentation.offsets.findIndex((end, i) => i > 0 && end > at) - 1;
  return { side: side === 0 ? "truth" : "prediction", place, distance: segmentation.distances[at] ?? NaN };
}

export function Tooltip({ hit, x, y }: Pointed): JSX.Element {
  const found = primitiveAt(hit);
  const state = scene.value;
  const segmentation = state.kind === "ready" ? (hit.side === 0 ? state.scene.truth : state.scene.prediction) : undefined;
  const primitive = found && segmentation?.primitives[found.place];
  return (
    <div class="tooltip" style={{ left: `${x}px`, top: `${y}px` }}>
      {primitive ? (
        <>
          <strong>
            {found.side === "truth" ? "True" : "Predicted"} {primitive.number}: {primitive.type ?? "other"}
          </strong>
          {primitive.surface && <span>{parameters(primitive.surface)}</span>}
          {!Number.isNaN(found.distance) && <span>distance {significant(found.distance)}</span>}
        </>
      ) : (
        <strong>Unsegmented</strong>
      )}
      <span>point {hit.index + 1}</span>
    </div>
  );
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
