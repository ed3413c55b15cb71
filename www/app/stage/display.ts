// How the points are shown; chosen once, kept for every model.

import { computed, signal } from "@preact/signals";
import { scene } from "../state/scene";
import { leftShows, rightIsTruth, type Side } from "../state/selection";
import { remembered } from "../state/settings";
import type { Cut, Layout } from "../view/types";
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

export const cut = computed<Cut | undefined>(() =>
  cutAcross.value === "none"
    ? undefined
    : { axis: CUTS.findIndex(({ id }) => id === cutAcross.value) - 1, share: cutAt.value, below: cutBelow.value },
);
