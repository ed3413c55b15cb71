// What the points show: labels and their colours, or a number per point, for each side.

import type { Report } from "../engine/contract";
import type { ModelScene, SegmentationScene } from "../../worker/protocol";
import { placeOfMatch } from "../state/matches";
import type { PrimitiveRef } from "../state/selection";
import { bytes, MISCLASSIFIED, OUTCOME_COLOURS, segmentColour, UNSEGMENTED } from "../view/palette";
import type { Side } from "../view/types";

export const COLOUR_MODES = [
  { id: "segments", title: "Segments" },
  { id: "figure", title: "The paper's figure" },
  { id: "outcome", title: "TP, FP, FN of the selected" },
  { id: "distance", title: "Distance to the surface" },
  { id: "type", title: "Type of surface" },
  { id: "normal", title: "Point normal" },
] as const;

export type ColourMode = (typeof COLOUR_MODES)[number]["id"];

export interface LegendEntry {
  readonly colour: string;
  readonly text: string;
}

/** Label 0 is for points that belong to nothing. */
export interface Labelling {
  readonly labels: Uint32Array;
  readonly colours: readonly string[];
  readonly legend?: readonly LegendEntry[];
  /** Whether the points show which way they face; the labels then only tell what is what. */
  readonly normals?: true;
  /** Colours the points in place of the labels, which then only tell what is what. */
  readonly scalars?: { readonly values: Float32Array; readonly low: number; readonly high: number };
}

export interface Shown {
  readonly scene: ModelScene;
  readonly report: Report | undefined;
  readonly selected: PrimitiveRef | undefined;
}

export const TYPE_COLOURS: Readonly<Record<string, string>> = {
  Plane: segmentColour(0),
  Cylinder: segmentColour(1),
  Cone: segmentColour(2),
  Sphere: segmentColour(3),
  Torus: segmentColour(5),
};

export function labelling(mode: ColourMode, side: Side, shown: Shown): Labelling {
  const { scene } = shown;
  const segmentation = side === 0 ? scene.truth : scene.prediction;
  const points = scene.positions.length / 3;
  if (mode === "outcome") return outcome(shown, points);
  if (!segmentation) {
    const nothing = { labels: new Uint32Array(points), colours: [UNSEGMENTED] };
    return mode === "normal" ? { ...nothing, normals: true } : nothing;
  }
  if (mode === "figure" && side === 1) return figure(shown, points);
  const labels = labelsOf(segmentation, points);
  if (mode === "type") {
    const colours = segmentation.primitives.map(({ type }) => TYPE_COLOURS[type ?? ""] ?? UNSEGMENTED);
    const legend = Object.entries(TYPE_COLOURS).map(([text, colour]) => ({ text, colour }));
    return { labels, colours: [UNSEGMENTED, ...colours], legend };
  }
  const colours = segmentColours(side, shown, segmentation.primitives.length);
  if (mode === "distance") return { labels, colours, scalars: distances(shown, segmentation, points) };
  if (mode === "normal") return { labels, colours, normals: true, legend: NORMAL_LEGEND };
  return { labels, colours };
}

/** Normals of points have no sign: one colour for both directions of an axis. */
const NORMAL_LEGEND: readonly LegendEntry[] = [
  { colour: "#ff0000", text: "faces ±x" },
  { colour: "#00ff00", text: "faces ±y" },
  { colour: "#0000ff", text: "faces ±z" },
];

/** A point listed by several primitives gets the first. */
function labelsOf({ offsets, indices }: SegmentationScene, points: number): Uint32Array {
  const labels = new Uint32Array(points);
  for (let primitive = offsets.length - 2; primitive >= 0; primitive--) {
    for (let at = offsets[primitive] ?? 0; at < (offsets[primitive + 1] ?? 0); at++) {
      labels[indices[at] ?? points] = primitive + 1;
    }
  }
  return labels;
}

/** A prediction has the colour of the true primitive it is matched with; others have colours of their own. */
export function predictionColours(report: Report | undefined, count: number): string[] {
  const colours: string[] = [];
  report?.primitives.forEach((_, truth) => {
    const match = placeOfMatch(report, truth);
    if (match !== undefined) colours[match] ??= segmentColour(truth);
  });
  const first = report?.primitives.length ?? 0;
  return Array.from({ length: count }, (_, place) => colours[place] ?? segmentColour(first + place));
}

/** Colour of every label of a side: unsegmented, then the primitives in their order. */
export function segmentColours(side: Side, { report }: Shown, count: number): string[] {
  const own = Array.from({ length: count }, (_, place) => segmentColour(place));
  return [UNSEGMENTED, ...(side === 0 ? own : predictionColours(report, count))];
}

/** Rightly found points in the colour of their true primitive, all others that the prediction lists in black. */
function figure({ scene, report }: Shown, points: number): Labelling {
  const { truth, prediction } = scene;
  const labels = new Uint32Array(points);
  if (!truth || !prediction || !report) return { labels, colours: [UNSEGMENTED] };
  const wrong = truth.primitives.length + 1;
  for (const index of prediction.indices) labels[index] = wrong;
  for (let place = truth.primitives.length - 1; place >= 0; place--) {
    const match = placeOfMatch(report, place);
    if (match === undefined) continue;
    const found = new Set(members(prediction, match));
    for (const index of members(truth, place)) if (found.has(index)) labels[index] = place + 1;
  }
  const colours = [UNSEGMENTED, ...truth.primitives.map((_, place) => segmentColour(place)), MISCLASSIFIED];
  const legend = [
    { colour: MISCLASSIFIED, text: "misclassified" },
    { colour: UNSEGMENTED, text: "not predicted" },
  ];
  return { labels, colours, legend };
}

/** True positives, false positives and false negatives of the selected primitive and its match. */
function outcome({ scene, report, selected }: Shown, points: number): Labelling {
  const labels = new Uint32Array(points);
  const { truePositive, falsePositive, falseNegative } = OUTCOME_COLOURS;
  const colours = [UNSEGMENTED, truePositive, falsePositive, falseNegative];
  const legend = [
    { colour: truePositive, text: "true positive" },
    { colour: falsePositive, text: "false positive" },
    { colour: falseNegative, text: "false negative" },
  ];
  const pair = report && selected && pairOf(report, selected);
  if (!pair) return { labels, colours, legend };
  const expected = new Set(pair.truth === undefined || !scene.truth ? [] : members(scene.truth, pair.truth));
  const found = pair.match === undefined || !scene.prediction ? [] : members(scene.prediction, pair.match);
  for (const index of expected) labels[index] = 3;
  for (const index of found) labels[index] = expected.has(index) ? 1 : 2;
  return { labels, colours, legend };
}

/** The true primitive and the prediction that a selection on either side is about. */
export function pairOf(report: Report, { side, index }: PrimitiveRef): { truth?: number; match?: number } {
  if (side === "truth") {
    const match = placeOfMatch(report, index);
    return match === undefined ? { truth: index } : { truth: index, match };
  }
  const truth = report.primitives.findIndex((_, place) => placeOfMatch(report, place) === index);
  return truth < 0 ? { match: index } : { truth, match: index };
}

export function members({ offsets, indices }: SegmentationScene, place: number): Uint32Array {
  return indices.subarray(offsets[place] ?? 0, offsets[place + 1] ?? 0);
}

/** One scale for both sides, so that they can be compared. */
function distances({ scene }: Shown, { indices, distances: own }: SegmentationScene, points: number) {
  const values = new Float32Array(points).fill(NaN);
  indices.forEach((index, at) => (values[index] = own[at] ?? NaN));
  return { values, low: 0, high: largestDistance(scene) };
}

/** Largest distance of a point to its surface, on either side. */
export function largestDistance({ truth, prediction }: ModelScene): number {
  let largest = 0;
  for (const segmentation of [truth, prediction]) {
    for (const distance of segmentation?.distances ?? []) if (distance > largest) largest = distance;
  }
  return largest || 1;
}

export function table({ colours }: Labelling): Uint8Array {
  return bytes(colours);
}
