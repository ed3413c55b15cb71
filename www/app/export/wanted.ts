// What the tables that leave the page are to show.

import { computed, signal } from "@preact/signals";
import { MEASURES } from "../../shared/formats/measures.mjs";
import { withPublished } from "../../shared/formats/published-rows.mjs";
import type { Result, Row } from "../../shared/formats/results.mjs";
import type { Wanted } from "../../shared/formats/wanted.mjs";
import type { Measure } from "../engine/contract";

export const means = signal(false);
export const bold = signal(false);
export const published = signal(false);
/** After the point; each format's own number where undefined. */
export const digits = signal<number | undefined>(undefined);
const left = signal<ReadonlySet<Measure>>(new Set());

/** Whether a measure is among the columns. */
export function isWanted(measure: Measure): boolean {
  return !left.value.has(measure);
}

/** Takes a measure in or leaves it out. */
export function want(measure: Measure, is: boolean): void {
  const others = [...left.peek()].filter((each) => each !== measure);
  left.value = new Set(is ? others : [...others, measure]);
}

export const wanted = computed<Wanted>(() => ({
  means: means.value,
  bold: bold.value,
  measures: MEASURES.filter(isWanted),
  ...(digits.value === undefined ? {} : { digits: digits.value }),
}));

/** The rows that tables are made of: the results, with the published ones where they are wanted. */
export function rowsFor(results: readonly Result[]): readonly Row[] {
  return published.value ? withPublished(results) : results;
}
