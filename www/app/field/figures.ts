// The figures that the field reports, and how they are written.

import { FIGURES } from "../../generated/declared/figures.js";
import { headOf } from "../../shared/formats/field.mjs";
import { ranksOf } from "../../shared/formats/field-sums.mjs";
import type { FieldSums } from "../../worker/protocol";
import type { FigureInfo } from "../engine/contract";
import { MISSING } from "../ui/format";

export { headOf, ranksOf };

export const PROTOCOLS_OF_FIELD: readonly FigureInfo[] = FIGURES.filter(({ group }) => group === "segmentation");
export const FIGURES_OF_FIT: readonly FigureInfo[] = FIGURES.filter(({ group }) => group === "fit");

export type Spread = NonNullable<FieldSums["spreads"][number]["figures"][number]["spread"]>;

export function written({ decimals, unit }: FigureInfo, value: number | null | undefined): string {
  return value === null || value === undefined ? MISSING : `${value.toFixed(decimals)}${unit}`;
}
