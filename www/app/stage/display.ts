// How the points are shown; chosen once, kept for every model.

import { computed, signal } from "@preact/signals";
import { scene } from "../state/scene";
import { leftShows, rightIsTruth, type Side } from "../state/selection";
import { remembered } from "../state/settings";
import type { ClipBox, Layout } from "../view/types";
import { COLOUR_MODES, segmentationOf, type ColourMode } from "./colouring";

export const ARRANGEMENTS = [
  { id: "split", title: "Side by side" },
  { id: "wipe", title: "Wipe" },
  { id: "truth", title: "Left only" },
  { id: "prediction", title: "Right only" },
] as const;

export type Arrangement = (typeof ARRANGEMENTS)[number]["id"];

export const colourMode = signal<ColourMode>(COLOUR_MODES[0].id);
export const arrangement = remembered<Arrangement>("arrangement", "split", ARRANGEMENTS.map(({ id }) => id));
/** Place of the wipe's border, 0 left to 1 right. */
export const wipeAt = signal(0.5);

/** What the left and the right view show. What is still on its way is not shown yet. */
export const sides = computed<readonly [Side, Side]>(() => {
  const state = scene.value;
  const there = state.kind === "ready" ? state.scene : undefined;
  const right = rightIsTruth.value && there?.truth ? "truth" : "prediction";
  if (leftShows.value === undefined) return ["truth", right];
  if (leftShows.value === there?.method) return ["prediction", right];
  return [leftShows.value === there?.rival?.method ? "rival" : "truth", right];
});

/** A side that has nothing to show leaves its room to the other. */
const possible = computed<Arrangement>(() => {
  const state = scene.value;
  if (state.kind !== "ready") return arrangement.value;
  const [left, right] = sides.value.map((side) => segmentationOf(state.scene, side) !== undefined);
  if (!right) return "truth";
  return left ? arrangement.value : "prediction";
});

export const layout = computed<Layout>(() => {
  switch (possible.value) {
    case "split":
      return { kind: "split" };
    case "wipe":
      return { kind: "wipe", at: wipeAt.value };
    case "truth":
      return { kind: "single", side: 0 };
    case "prediction":
      return { kind: "single", side: 1 };
  }
});

export const eyeDome = remembered("eye-dome", "on", ["on", "off"] as const);
/** Whether the fitted surface of the selected primitive is drawn. */
export const surfaces = remembered("surfaces", "on", ["on", "off"] as const);
export const surfacesShown = computed(() => surfaces.value === "on");
export const unsegmentedShown = remembered("unsegmented", "on", ["on", "off"] as const);
export const projection = remembered("projection", "perspective", ["perspective", "orthographic"] as const);
/** Diameter of a point over the typical distance of neighbours. */
export const pointSize = signal(1.6);

/** What the cloud is cut open across, and where. */
export const CUTS = [
  { id: "none", title: "nothing" },
  { id: "x", title: "x" },
  { id: "y", title: "y" },
  { id: "z", title: "z" },
] as const;

export const cutAcross = signal<(typeof CUTS)[number]["id"]>("none");
export const cutAt = signal(0.5);
export const cutBelow = signal(false);

/** The shares of the cloud's extent along x, y and z between which points are shown; all of them where there is no box. */
export const clipBox = signal<ClipBox | undefined>(undefined);
/** As the box is at first: it hides nothing. */
export const WHOLE_BOX: ClipBox = { low: [0, 0, 0], high: [1, 1, 1] };

/** Takes the box away, then the cut. */
export function takeCutBack(): void {
  if (clipBox.value) clipBox.value = undefined;
  else cutAcross.value = "none";
}

/** The plane that cuts the cloud open: across the axis 0, 1 or 2, from 0 at the least coordinate to 1 at the greatest. */
export const cut = computed(() =>
  cutAcross.value === "none" ? undefined : { axis: CUTS.findIndex(({ id }) => id === cutAcross.value) - 1, share: cutAt.value },
);

/** What box and cut both leave. */
export const shownBox = computed<ClipBox>(() => {
  const { low, high } = clipBox.value ?? WHOLE_BOX;
  const { axis, share } = cut.value ?? { axis: -1, share: 0 };
  const cutAway = ([x, y, z]: ClipBox["low"], to: (side: number) => number): ClipBox["low"] => [
    axis === 0 ? to(x) : x,
    axis === 1 ? to(y) : y,
    axis === 2 ? to(z) : z,
  ];
  return cutBelow.value
    ? { low: cutAway(low, (side) => Math.max(side, share)), high }
    : { low, high: cutAway(high, (side) => Math.min(side, share)) };
});
