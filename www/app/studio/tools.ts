// What is being cut away next: the tool in hand, and the ball before it is cut.

import { computed, signal } from "@preact/signals";
import type { Cut, Vector } from "./case";
import { current, edit, made } from "./state";

export type Tool = "turn" | "lasso" | "ball";
export type Reach = "through" | "seen";

export const tool = signal<Tool>("turn");
/** How deep a lasso cuts: all the way through, or as deep as the deepest point that can be seen. */
export const reach = signal<Reach>("through");

const placed = signal<{ readonly centre: Vector; readonly radius: number | undefined } | undefined>(undefined);

/** The ball in hand, in the coordinates of the files. */
export const ball = computed(() => {
  const result = made.value?.result;
  if (!result) return undefined;
  const usual = Number((result.diagonal / 10).toPrecision(2));
  return { centre: placed.value?.centre ?? result.centre, radius: placed.value?.radius ?? usual };
});

export function placeBall(change: Partial<{ centre: Vector; radius: number }>): void {
  if (ball.value) placed.value = { ...ball.value, ...change };
}

/** Where a point of the case is, counted from 0. */
export function pointAt(index: number): Vector | undefined {
  const result = made.value?.result;
  if (!result || index < 0 || 3 * index >= result.positions.length) return undefined;
  const { positions, centre } = result;
  const at = (axis: 0 | 1 | 2) => Number(((positions[3 * index + axis] ?? 0) + centre[axis]).toPrecision(7));
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
