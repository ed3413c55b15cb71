// Distances as shares of the primitive's diagonal.

import { MISSING } from "../ui/format";

/** Less is rounding. */
const NEGLIGIBLE = 1e-9;

/** In per cent with three digits; what would be shown as nothing, in powers of ten. */
export function ofDiagonal(value: number | null | undefined): string {
  if (value === null || value === undefined) return MISSING;
  const percent = 100 * value;
  if (Math.abs(percent) > NEGLIGIBLE && Math.abs(percent) < 0.001) return `${percent.toExponential(1).replace("e-", "e−")} %`;
  return `${percent.toFixed(3)} %`;
}
