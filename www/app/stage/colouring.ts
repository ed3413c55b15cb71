// What the points show: labels and their colours, or a number per point, for each side.

import type { Report } from "../engine/contract";
import type { ModelScene, SegmentationScene } from "../../worker/protocol";
import { placeOfMatch, truthOfMatch } from "../state/matches";
import type { PrimitiveRef, Side } from "../state/selection";
import { bytes, MISCLASSIFIED, OUTCOME_COLOURS, segmentColour, UNSEGMENTED } from "../view/palette";

export const COLOUR_MODES = [
  { id: "segments", title: "Segments" },
  { id: "figure", title: "The paper's figure" },
  { id: "outcome", title: "TP, FP, FN of the selected" },
  { id: "distance", title: "Distance to the surface" },
  { id: "type", title: "Type of surface" },
  { id: "normal", title: "Point normal" },
] as const;

export type ColourMode = (typeof COLOUR_MODES)[number]["id"];

/** Label 0 is for points that belong to nothing. */
export interface Labelling {
  readonly labels: Uint32Array;
  readonly colours: readonly string[];
  /** Whether the points show which way they face; the labels then only tell what is what. */
  readonly normals?: true;
  /** Colours the points in place of the labels, which then only tell what is what. */
  readonly scalars?: { readonly values: Float32Array; readonly low: number; readonly high: number };
}

/** How the two submissions that may be shown match the truth. */
export type Reports = Readonly<Partial<Record<"prediction" | "rival", Report | undefined>>>;

export interface Shown {
  readonly scene: ModelScene;
  readonly reports: Reports;
  readonly selected: PrimitiveRef | undefined;
}

export const TYPE_COLOURS: Readonly<Record<string, string>> = {
  Plane: segmentColour(0),
  Cylinder: segmentColour(1),
  Cone: segmentColour(2),
  Sphere: segmentColour(3),
  Torus: segmentColour(5),
};

export function segmentationOf({ truth, prediction, rival }: ModelScene, side: Side): SegmentationScene | undefined {
  return { truth, prediction, rival: rival?.segmentation }[side];
}

/** The submission that a side is about: the truth stands beside the selected one. */
function submissionOf(side: Side): "prediction" | "rival" {
  return side === "rival" ? "rival" : "prediction";
}

export function labelling(mode: ColourMode, side: Side, shown: Shown): Labelling {
  const { scene } = shown;
  const segmentation = segmentationOf(scene, side);
  const points = scene.positions.length / 3;
  if (mode === "outcome") return outcome(side, shown, points);
  if (!segmentation) {
    const nothing = { labels: new Uint32Array(points), colours: [UNSEGMENTED] };
    return mode === "normal" ? { ...nothing, normals: true } : nothing;
  }
  if (mode === "figure" && side !== "truth") return figure(side, shown, points);
  const order = drawingOrder(side, shown.reports, segmentation);
  const labels = labelsOf(segmentation, points, order);
  if (mode === "type") {
    const colours = segmentation.primitives.map(({ type }) => TYPE_COLOURS[type ?? ""] ?? UNSEGMENTED);
    return { labels, colours: [UNSEGMENTED, ...colours] };
  }
  const colours = segmentColours(side, shown.reports, segmentation.primitives.length);
  if (mode === "distance") return { labels, colours, scalars: distances(scene, segmentation, points, order) };
  if (mode === "normal") return { labels, colours, normals: true };
  return { labels, colours };
}

/**
 * The places of a side's primitives as one is drawn over the other where they share points: the last is seen. On top is
 * the first true primitive, and of a submission that which is matched with the first: a perfect one looks like the truth,
 * in whatever order it lists its primitives.
 */
export function drawingOrder(side: Side, reports: Reports, { primitives }: SegmentationScene): number[] {
  const places = primitives.map((_, place) => place);
  if (side === "truth") return places.reverse();
  const rank = (place: number) => truthOfMatch(reports[side], place) ?? Infinity;
  // Those without a match lie below all others, the first of them on top.
  return places.sort((a, b) => (rank(a) === rank(b) ? b - a : rank(b) - rank(a)));
}

/** A label per point: the place from 1 of the primitive seen there, 0 for none. */
export function labelsOf(segmentation: SegmentationScene, points: number, order: readonly number[]): Uint32Array {
  const labels = new Uint32Array(points);
  for (const place of order) {
    for (const index of members(segmentation, place)) labels[index] = place + 1;
  }
  return labels;
}

/** A prediction has the colour of the true primitive it is matched with; others have colours of their own. */
export function predictionColours(report: Report | undefined, count: number): string[] {
  const first = report?.primitives.length ?? 0;
  return Array.from({ length: count }, (_, place) => segmentColour(truthOfMatch(report, place) ?? first + place));
}

/** Colour of every label of a side: unsegmented, then the primitives in their order. */
export function segmentColours(side: Side, reports: Reports, count: number): string[] {
  const own = Array.from({ length: count }, (_, place) => segmentColour(place));
  return [UNSEGMENTED, ...(side === "truth" ? own : predictionColours(reports[side], count))];
}

/** Rightly found points in the colour of their true primitive, all others that the submission lists in black. */
function figure(side: "prediction" | "rival", { scene, reports }: Shown, points: number): Labelling {
  const found = segmentationOf(scene, side);
  const { truth } = scene;
  const report = reports[side];
  const labels = new Uint32Array(points);
  if (!truth || !found || !report) return { labels, colours: [UNSEGMENTED] };
  const wrong = truth.primitives.length + 1;
  for (const index of found.indices) labels[index] = wrong;
  for (let place = truth.primitives.length - 1; place >= 0; place--) {
    const match = placeOfMatch(report, place);
    if (match === undefined) continue;
    const matched = new Set(members(found, match));
    for (const index of members(truth, place)) if (matched.has(index)) labels[index] = place + 1;
  }
  return { labels, colours: [UNSEGMENTED, ...truth.primitives.map((_, place) => segmentColour(place)), MISCLASSIFIED] };
}

/** True positives, false positives and false negatives of the selected primitive and its match. */
function outcome(side: Side, { scene, reports, selected }: Shown, points: number): Labelling {
  const labels = new Uint32Array(points);
  const { truePositive, falsePositive, falseNegative } = OUTCOME_COLOURS;
  const colours = [UNSEGMENTED, truePositive, falsePositive, falseNegative];
  const submission = submissionOf(side);
  if (!selected || !reports[submission]) return { labels, colours };
  const partners = partnersOf(reports, selected);
  const membersOn = (of: Side) => {
    const [segmentation, place] = [segmentationOf(scene, of), partners[of]];
    return segmentation && place !== undefined ? members(segmentation, place) : [];
  };
  const expected = new Set(membersOn("truth"));
  for (const index of expected) labels[index] = 3;
  for (const index of membersOn(submission)) labels[index] = expected.has(index) ? 1 : 2;
  return { labels, colours };
}

/** The places of the true primitive and of its matches that a primitive of any side is about. */
export type Partners = Readonly<Partial<Record<Side, number>>>;

export function partnersOf(reports: Reports, { side, index }: PrimitiveRef): Partners {
  const truth = side === "truth" ? index : truthOfMatch(reports[side], index);
  const matchIn = (report: Report | undefined) => (report && truth !== undefined ? placeOfMatch(report, truth) : undefined);
  const [prediction, rival] = [matchIn(reports.prediction), matchIn(reports.rival)];
  return {
    ...(truth !== undefined && { truth }),
    ...(prediction !== undefined && { prediction }),
    ...(rival !== undefined && { rival }),
    [side]: index,
  };
}

export function members({ offsets, indices }: SegmentationScene, place: number): Uint32Array {
  return indices.subarray(offsets[place] ?? 0, offsets[place + 1] ?? 0);
}

/** One scale for all sides, so that they can be compared. */
function distances(scene: ModelScene, { offsets, indices, distances: own }: SegmentationScene, points: number, order: readonly number[]) {
  const values = new Float32Array(points).fill(NaN);
  for (const place of order) {
    for (let at = offsets[place] ?? 0; at < (offsets[place + 1] ?? 0); at++) values[indices[at] ?? points] = own[at] ?? NaN;
  }
  return { values, low: 0, high: largestDistance(scene) };
}

const largest = new WeakMap<ModelScene, number>();

/** Largest distance of a point to its surface, on any side. */
export function largestDistance(scene: ModelScene): number {
  const known = largest.get(scene);
  if (known !== undefined) return known;
  let found = 0;
  for (const segmentation of [scene.truth, scene.prediction, scene.rival?.segmentation]) {
    for (const distance of segmentation?.distances ?? []) if (distance > found) found = distance;
  }
  largest.set(scene, found || 1);
  return found || 1;
}

export function table({ colours }: Labelling): Uint8Array {
  return bytes(colours);
}
