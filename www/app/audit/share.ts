// Distances as shares of the primitive's diagonal.

import { MISSING } from "../ui/format";

/** In per cent with three digits; what would be shown as nothing, in powers of ten. */
export function ofDiagonal(value: number | null | undefined): string {
  if (value === null || value === undefined) return MISSING;
  const percent = 100 * value;
  if (percent !== 0 && Math.abs(percent) < 0.001) return `${percent.toExponential(1).replace("e-", "e−")} %`;
  return `${percent.toFixed(3)} %`;
}
