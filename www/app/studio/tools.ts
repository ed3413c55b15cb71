// What is being cut away next: the tool in hand, and the ball before it is cut.

import { computed, effect, signal } from "@preact/signals";
import { latest } from "../engine/latest";
import type { Cut, Vector } from "./case";
import { rounded } from "./rounding";
import { ask, current, edit, made } from "./state";

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
  if (!result || index < 0 || 3 * index >= result.positions.length) return undefined;
  const { positions, centre, diagonal } = result;
  const at = (axis: 0 | 1 | 2) => (positions[3 * index + axis] ?? 0) + centre[axis];
  return rounded([at(0), at(1), at(2)], diagonal);
}

/** The points inside the ball in hand, as the engine counts them; none while another tool is. */
export const inBall = signal<Uint32Array | readonly number[]>([]);

/** The ball may move faster than its points are counted. */
const count = latest(async (held: { readonly centre: Vector; readonly radius: number } | undefined) => {
  inBall.value = held ? await ask((engine) => engine.pointsInBall(held.centre, held.radius)) : [];
});

/** Keeps the points inside the ball in step with it and with the case, until the result is called. */
export function followBall(): () => void {
  return effect(() => {
    const held = tool.value === "ball" && made.value ? ball.value : undefined;
    // Without an answer there is nothing to cut, which the next one mends.
    count(held).catch(() => (inBall.value = []));
  });
}

export function cutAway(cut: Cut): void {
  edit({ cuts: [...current.value.cuts, cut] }, cut.kind === "ball" ? "Cut a ball" : "Cut with the lasso");
}

export function cutBall(): void {
  if (ball.value) cutAway({ kind: "ball", ...ball.value });
}
