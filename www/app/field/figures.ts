// The figures that the field reports, and how they are written.

import { FIGURES } from "../../generated/declared/figures.js";
import { headOf } from "../../shared/formats/field.mjs";
import type { FieldSums } from "../../worker/protocol";
import type { FigureInfo } from "../engine/contract";
import { MISSING } from "../ui/format";

export { headOf };

export const PROTOCOLS_OF_FIELD: readonly FigureInfo[] = FIGURES.filter(({ group }) => group === "segmentation");
export const FIGURES_OF_FIT: readonly FigureInfo[] = FIGURES.filter(({ group }) => group === "fit");

export type Spread = NonNullable<FieldSums["spreads"][number]["figures"][number]["spread"]>;

export function written({ decimals, unit }: FigureInfo, value: number | null | undefined): string {
  return value === null || value === undefined ? MISSING : `${value.toFixed(decimals)}${unit}`;
}

/** The place of each method by a figure, from 1, equals sharing one; absent for those without a figure. */
export function ranksOf(spreads: FieldSums["spreads"], { key, better, decimals }: FigureInfo): ReadonlyMap<string, number> {
  const values = spreads.flatMap(({ method, figures }) => {
    const mean = figures.find(({ figure }) => figure === key)?.spread?.mean;
    return mean === undefined ? [] : [{ method, mean: Number(mean.toFixed(decimals)) }];
  });
  const isBetter = (one: number, other: number) => (better === "higher" ? one > other : one < other);
  return new Map(values.map(({ method, mean }) => [method, 1 + values.filter((each) => isBetter(each.mean, mean)).length]));
}
