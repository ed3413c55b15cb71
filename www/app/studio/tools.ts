// What is being cut away next: the tool in hand, and the ball before it is cut.

import { computed, signal } from "@preact/signals";
import type { Cut, Vector } from "./case";
import { rounded } from "./rounding";
import { current, edit, made } from "./state";

export type Tool = "turn" | "lasso" | "ball";
export type Reach = "through" | "seen";

export const tool = signal<Tool>("turn");
/** How deep a lasso cuts: all the way through, or as deep as the deepest point that can be seen. */
export const reach = signal<Reach>("through");

interface Placed {
  readonly centre: Vector | undefined;
  readonly radius: number | undefined;
  /** The point it was put on, counted from 0. */
  readonly point: number | undefined;
}

const placed = signal<Placed>({ centre: undefined, radius: undefined, point: undefined });

/** The ball in hand, in the coordinates of the files. */
export const ball = computed(() => {
  const result = made.value?.result;
  if (!result) return undefined;
  const { centre, radius } = placed.value;
  return {
    centre: centre ?? rounded(result.centre, result.diagonal),
    radius: radius ?? Number((result.diagonal / 10).toPrecision(2)),
  };
});

/** The point the ball is on, counted from 0; nothing once either has moved. */
export const ballPoint = computed(() => {
  const { centre, point } = placed.value;
  const place = point === undefined ? undefined : pointAt(point);
  return place && centre?.every((coordinate, axis) => coordinate === place[axis]) ? point : undefined;
});

export function placeBall(change: Partial<{ centre: Vector; radius: number }>): void {
  placed.value = { ...placed.value, ...change };
}

/** Puts the ball on a point, counted from 0. */
export function placeBallOn(point: number): void {
  const centre = pointAt(point);
  if (centre) placed.value = { ...placed.value, centre, point };
}

/** Where a point of the case is, counted from 0, without digits that say nothing. */
export function pointAt(index: number): Vector | undefined {
  const result = made.value?.result;
  const place = exactPointAt(index);
  return result && place && rounded(place, result.diagonal);
}

/** The same as the engine has it, but for single precision. */
export function exactPointAt(index: number): Vector | undefined {
  const result = made.value?.result;
  if (!result || index < 0 || 3 * index >= result.positions.length) return undefined;
  const { positions, centre } = result;
  const at = (axis: 0 | 1 | 2) => (positions[3 * index + axis] ?? 0) + centre[axis];
  return [at(0), at(1), at(2)];
}

/** The points inside the ball in hand; none while another tool is. */
export const inBall = computed<readonly number[]>(() => {
  const result = made.value?.result;
  if (tool.value !== "ball" || !ball.value || !result) return [];
  const { positions } = result;
  const [x, y, z] = ball.value.centre.map((coordinate, axis) => coordinate - (result.centre[axis] ?? 0));
  const square = ball.value.radius ** 2;
  const inside: number[] = [];
  for (let at = 0; at < positions.length; at += 3) {
    const [dx, dy, dz] = [(positions[at] ?? 0) - (x ?? 0), (positions[at + 1] ?? 0) - (y ?? 0), (positions[at + 2] ?? 0) - (z ?? 0)];
    if (dx * dx + dy * dy + dz * dz <= square) inside.push(at / 3);
  }
  return inside;
});

export function cutAway(cut: Cut): void {
  edit({ cuts: [...current.value.cuts, cut] }, cut.kind === "ball" ? "Cut a ball" : "Cut with the lasso");
}

export function cutBall(): void {
  if (ball.value) cutAway({ kind: "ball", ...ball.value });
}
