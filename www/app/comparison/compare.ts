// A method against another: what the engine makes of the figures of both.

import { signal } from "@preact/signals";
import { rowsOf } from "../../shared/formats/measures.mjs";
import { engine } from "../engine/client";
import type { Comparison, Measure } from "../engine/contract";
import { latest } from "../engine/latest";

/** The figures of one model. */
export interface Pair {
  readonly own: (measure: Measure) => number | null;
  readonly theirs: (measure: Measure) => number | null;
}

/** The comparison of what was asked about last, by measure, with the rows that it is of. */
export interface Compared<Row> {
  readonly rows: readonly Row[];
  readonly by: ReadonlyMap<Measure, Comparison>;
}

/** Keeps a comparison of rows that may change faster than they are compared. */
export function comparing<Row>(pairOf: (row: Row) => Pair) {
  const compared = signal<Compared<Row> | undefined>(undefined);
  const ask = latest(async (rows: readonly Row[]) => {
    const pairs = rows.map(pairOf);
    const [own, theirs] = [rowsOf(pairs.map((pair) => pair.own)), rowsOf(pairs.map((pair) => pair.theirs))];
    const found = await engine.run((api) => api.compare(own, theirs));
    compared.value = { rows, by: new Map(found.map((comparison) => [comparison.measure, comparison])) };
  });
  return { compared, ask };
}
