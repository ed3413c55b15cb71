// The points of a range of distances to the surface, that stand out in the picture while all others are faded. The
// chart of distances chooses the range and asks the engine for the points.

import { computed, signal } from "@preact/signals";
import type { Side } from "../state/selection";
import { where } from "./where";

interface Brushed {
  readonly where: string;
  /** Indices of the points, ascending and each once. */
  readonly points: Readonly<Partial<Record<Side, Uint32Array>>>;
  /** The range and the numbers of points, in words. */
  readonly words: string;
}

/** A range of distances in the units of the file, both ends in it. */
interface Range {
  readonly where: string;
  readonly low: number;
  readonly high: number;
}

const chosen = signal<Range | undefined>(undefined);
const answered = signal<Brushed | undefined>(undefined);

/** The range that is chosen, of what is in view. */
export const brush = computed(() => (chosen.value?.where === where.value ? chosen.value : undefined));
/** Its points, once the engine has said which they are. */
export const brushed = computed(() => (brush.value && answered.value?.where === where.value ? answered.value : undefined));

export function setBrush(low: number, high: number): void {
  chosen.value = { where: where.value, low, high };
}

export function setBrushed(found: Brushed | undefined): void {
  answered.value = found;
}

/** Takes the range back; whether there was one. */
export function takeBrushBack(): boolean {
  if (!brush.value) return false;
  chosen.value = undefined;
  answered.value = undefined;
  return true;
}
