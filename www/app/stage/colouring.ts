// What the points show: labels and their colours, or a number per point, for each side.

import type { Report } from "../engine/contract";
import type { ModelScene, SegmentationScene } from "../../worker/protocol";
import { placeOfMatch, truthOfMatch } from "../state/matches";
import type { PrimitiveRef, Side } from "../state/selection";
import { bytes, MISCLASSIFIED, OUTCOME_COLOURS, segmentColour, typeColour, UNSEGMENTED } from "../view/palette";

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
  /** What the engine makes of each submission's points, where it has been asked and has answered. */
  readonly outcomes?: Outcomes;
  /** The points that stand out, where not all do: all others have labels of their own, to be faded. */
  readonly brushed?: Readonly<Partial<Record<Side, Uint32Array>>> | undefined;
}

/** Labels of points by what a submission makes of them, in the modes that show that. */
export type Outcomes = Readonly<Partial<Record<"prediction" | "rival", Uint32Array>>>;

export function segmentationOf({ truth, prediction, rival }: ModelScene, side: Side): SegmentationScene | undefined {
  return { truth, prediction, rival: rival?.segmentation }[side];
}

/** The submission that a side is about: the truth stands beside the selected one. */
export function submissionOf(side: Side): "prediction" | "rival" {
  return side === "rival" ? "rival" : "prediction";
}

export function labelling(mode: ColourMode, side: Side, shown: Shown): Labelling {
  const whole = unbrushed(mode, side, shown);
  return shown.brushed ? brushedOut(whole, shown.brushed[side] ?? new Uint32Array()) : whole;
}

/** Every label twice: as it was for the points that stand out, and in a second series for all others. */
function brushedOut(whole: Labelling, points: Uint32Array): Labelling {
  const { labels, colours } = whole;
  const moved = labels.map((label) => label + colours.length);
  for (const index of points) moved[index] = labels[index] ?? 0;
  return { ...whole, labels: moved, colours: [...colours, ...colours] };
}

function unbrushed(mode: ColourMode, side: Side, shown: Shown): Labelling {
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
    const colours = segmentation.primitives.map(({ type }) => typeColour(type));
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

/** The engine's labels of a submission; nothing predicted until it has answered, for this model. */
function outcomesOf(side: Side, { outcomes }: Shown, points: number): Uint32Array {
  const known = outcomes?.[submissionOf(side)];
  return known?.length === points ? known : new Uint32Array(points);
}

/** Rightly found points in the colour of their true primitive, all others that the submission lists in black. */
function figure(side: Side, shown: Shown, points: number): Labelling {
  const truth = shown.scene.truth?.primitives ?? [];
  const colours = [UNSEGMENTED, ...truth.map((_, place) => segmentColour(place)), MISCLASSIFIED];
  return { labels: outcomesOf(side, shown, points), colours };
}

/** True positives, false positives and false negatives of the selected primitive and its match, in the engine's order. */
function outcome(side: Side, shown: Shown, points: number): Labelling {
  const { truePositive, falsePositive, falseNegative } = OUTCOME_COLOURS;
  return { labels: outcomesOf(side, shown, points), colours: [UNSEGMENTED, truePositive, falsePositive, falseNegative] };
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

/** Whether a primitive is meant by another: it is the same, or a partner of it. */
export function isMeantBy(reports: Reports, ref: PrimitiveRef | undefined, { side, index }: PrimitiveRef): boolean {
  return ref !== undefined && partnersOf(reports, ref)[side] === index;
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
  return { values, low: 0, high: distanceScale(scene).end };
}

/**
 * The end of the scale of distances, the same for all sides: that within which most points lie on the side where they
 * lie farthest. Where that is none, the largest distance.
 */
export function distanceScale({ truth, prediction, rival }: ModelScene): { readonly end: number; readonly more: boolean } {
  const sides = [truth, prediction, rival?.segmentation];
  const farthest = Math.max(...sides.map((side) => side?.farthest ?? 0));
  const end = Math.max(...sides.map((side) => side?.usual ?? 0)) || farthest || 1;
  return { end, more: farthest > end };
}

/** The end of that scale in words. */
export function endOfScale(scene: ModelScene): string {
  const { end, more } = distanceScale(scene);
  return `${Number(end.toPrecision(3))} units of the file${more ? " and more" : ""}`;
}

export function table({ colours }: Labelling): Uint8Array {
  return bytes(colours);
}
