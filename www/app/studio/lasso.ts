// From a curve drawn on the screen to a region of space.

import { FIELD_OF_VIEW, type CameraState } from "../view/types";
import type { Lasso, Vector } from "./case";

type Place = readonly [number, number];

/** The view as the curve was drawn on it, in pixels of the page. */
export interface Screen {
  readonly width: number;
  readonly height: number;
  readonly camera: CameraState;
  /** What the camera's places are relative to. */
  readonly centre: Vector;
}

/** How far a corner that is left out may lie from the curve, in pixels. */
const TOLERANCE = 0.75;
/** As many as the engine takes. */
const MAX_CORNERS = 1000;

/** The region that a curve encloses, all the way through; nothing where it encloses nothing. */
export function lassoOf(curve: readonly Place[], screen: Screen): Lasso | undefined {
  const drawn = simplified(curve, TOLERANCE).slice(0, MAX_CORNERS);
  if (drawn.length < 3) return undefined;
  const { width, height, camera, centre } = screen;
  const unit = camera.height / height;
  const { target, rotation } = camera;
  const [x, y, z, w] = rotation;
  return {
    kind: "lasso",
    target: [centre[0] + target[0], centre[1] + target[1], centre[2] + target[2]],
    rotation: [x, y, z, w],
    eye: camera.projection === "perspective" ? camera.height / 2 / Math.tan(FIELD_OF_VIEW / 2) : Infinity,
    depth: Infinity,
    // As exact as links keep them: what is sent is what was cut.
    corners: drawn.map(([x, y]) => [Math.fround((x - width / 2) * unit), Math.fround((height / 2 - y) * unit)]),
  };
}

/** How far a place lies beyond the camera's target. */
export function depthOf({ target, rotation: [x, y, z, w] }: Lasso, place: Vector): number {
  // The camera's back, its z axis, in the world.
  const back = [2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)] as const;
  return -back.reduce((sum, part, axis) => sum + part * ((place[axis] ?? 0) - (target[axis] ?? 0)), 0);
}

/** The curve with fewer corners (Douglas and Peucker 1973). */
function simplified(curve: readonly Place[], tolerance: number): readonly Place[] {
  const kept = new Set([0, curve.length - 1]);
  const open: [number, number][] = [[0, curve.length - 1]];
  for (let range = open.pop(); range; range = open.pop()) {
    const [from, to] = range;
    let farthest = { at: -1, distance: tolerance };
    for (let at = from + 1; at < to; at += 1) {
      const distance = distanceTo(curve[at], curve[from], curve[to]);
      if (distance > farthest.distance) farthest = { at, distance };
    }
    if (farthest.at < 0) continue;
    kept.add(farthest.at);
    open.push([from, farthest.at], [farthest.at, to]);
  }
  return curve.filter((_, at) => kept.has(at));
}

/** From a place to the line between two others. */
function distanceTo([x, y]: Place = [0, 0], [ax, ay]: Place = [0, 0], [bx, by]: Place = [0, 0]): number {
  const [dx, dy] = [bx - ax, by - ay];
  const square = dx * dx + dy * dy;
  const share = square > 0 ? Math.min(1, Math.max(0, ((x - ax) * dx + (y - ay) * dy) / square)) : 0;
  return Math.hypot(x - ax - share * dx, y - ay - share * dy);
}
