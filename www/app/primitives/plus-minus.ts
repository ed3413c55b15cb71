// Numbers with their standard errors: as many digits as the error leaves sure.

/** Digits of a number whose error is not known, or smaller still. */
const DIGITS = 5;

/** `5.02 ± 0.01`; the number alone where its error is not known. */
export function plusMinus(value: number, error: number | null | undefined): string {
  if (!isKnown(error)) return value.toPrecision(DIGITS);
  const decimals = decimalsOf(error);
  if (value === 0 || decimals > DIGITS - 1 - Math.floor(Math.log10(Math.abs(value)))) return `${value.toPrecision(DIGITS)} ${offBy(error)}`;
  return `${value.toFixed(Math.max(0, decimals))} ± ${error.toFixed(Math.max(0, decimals))}`;
}

/** `± 0.01`, `± 3e−9`; nothing where it is not known. */
export function offBy(error: number | null | undefined): string {
  if (!isKnown(error)) return "";
  const decimals = decimalsOf(error);
  return `± ${decimals > DIGITS ? error.toExponential(0).replace("e-", "e−") : error.toFixed(Math.max(0, decimals))}`;
}

/** One of nothing at all is that of numbers which are exact, and tells nothing. */
function isKnown(error: number | null | undefined): error is number {
  return typeof error === "number" && error > 0 && Number.isFinite(error);
}

/** Decimals of its first digit, once it is rounded to that. */
function decimalsOf(error: number): number {
  return -Math.floor(Math.log10(Number(error.toPrecision(1))));
}
