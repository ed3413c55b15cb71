// What the colours mean, in words: for the legend beside the points and for saved pictures.

import { SURFACE_TYPES } from "../../generated/declared/surface-types.js";
import type { ModelScene } from "../../worker/protocol";
import type { Side } from "../state/selection";
import { MISCLASSIFIED, OUTCOME_COLOURS, typeColour, UNSEGMENTED } from "../view/palette";
import { segmentationOf, segmentColours, type ColourMode, type Shown } from "./colouring";

export interface KeyEntry {
  readonly colour: string;
  readonly text: string;
}

const OUTCOME: readonly KeyEntry[] = [
  { colour: OUTCOME_COLOURS.truePositive, text: "true positive" },
  { colour: OUTCOME_COLOURS.falsePositive, text: "false positive" },
  { colour: OUTCOME_COLOURS.falseNegative, text: "false negative" },
];

const FIGURE: readonly KeyEntry[] = [
  { colour: MISCLASSIFIED, text: "misclassified" },
  { colour: UNSEGMENTED, text: "not predicted" },
];

const REST: KeyEntry = { colour: UNSEGMENTED, text: "of none of these" };

/** Normals of points have no sign: one colour for both directions of an axis. */
const NORMAL: readonly KeyEntry[] = [
  { colour: "#ff0000", text: "faces ±x" },
  { colour: "#00ff00", text: "faces ±y" },
  { colour: "#0000ff", text: "faces ±z" },
];

/** Colours that mean the same in every model; none where they only tell primitives apart, or are a scale. */
export function fixedKey(mode: ColourMode): readonly KeyEntry[] {
  switch (mode) {
    case "outcome":
      return OUTCOME;
    case "figure":
      return FIGURE;
    case "normal":
      return NORMAL;
    case "type":
      return [...SURFACE_TYPES.map(({ name }) => ({ colour: typeColour(name), text: name })), REST];
    case "segments":
    case "distance":
      return [];
  }
}

/**
 * The primitives of the sides by their colours, each with its type. A true primitive and its match
 * share a colour and an entry, which is worded as on the first side that has it.
 */
export function primitiveKey(sides: readonly Side[], { scene, reports }: Pick<Shown, "scene" | "reports">): readonly KeyEntry[] {
  const entries = new Map<string, KeyEntry>();
  for (const side of sides) {
    const primitives = segmentationOf(scene, side)?.primitives ?? [];
    const colours = segmentColours(side, reports, primitives.length);
    primitives.forEach(({ number, type }, place) => {
      const colour = colours[place + 1] ?? UNSEGMENTED;
      const text = `${number} ${type ?? "other"}${side === "truth" ? "" : ` of ${nameOf(side, scene)}`}`;
      if (!entries.has(colour)) entries.set(colour, { colour, text });
    });
  }
  return [...entries.values()];
}

export function nameOf(side: Side, { method, rival }: ModelScene): string {
  return { truth: "truth", prediction: method ?? "points", rival: rival?.method ?? "" }[side];
}
