// How numbers are written.

import type { Measure } from "../engine/contract";
import { MEASURE } from "../measures/measures";

const INTEGER = new Intl.NumberFormat("en");

export function integer(value: number): string {
  return INTEGER.format(value);
}

/** A count where there is little room: `0`, `500`, `1.5k`, `20k`, `2M`. */
export function shortCount(value: number): string {
  const [size, unit] = Math.abs(value) >= 1e6 ? [1e6, "M"] : Math.abs(value) >= 1e3 ? [1e3, "k"] : [1, ""];
  return `${Number((value / size).toPrecision(6))}${unit}`;
}

export const MISSING = "n/a";

/** A measure as shown in a table: with the digits that tell something, small errors in powers of ten. */
export function measure(name: Measure, value: number | null | undefined): string {
  if (value === null || value === undefined) return MISSING;
  const { better, decimals } = MEASURE[name];
  const small = better === "lower" && value !== 0 && Math.abs(value) < 10 ** -decimals;
  return small ? value.toExponential(1).replace("e-", "e−") : value.toFixed(decimals);
}

export function plural(count: number, noun: string): string {
  return `${integer(count)} ${noun}${count === 1 ? "" : "s"}`;
}

/** Words as they begin a sentence or a label. */
export function capitalised(words: string): string {
  return words.charAt(0).toUpperCase() + words.slice(1);
}

/** A span of time, roughly: `8 s`, `2 min`. */
export function duration(milliseconds: number): string {
  const seconds = Math.ceil(milliseconds / 1000);
  return seconds < 90 ? `${seconds} s` : `${Math.round(seconds / 60)} min`;
}

/** A length, roughly: two digits, in powers of ten where they would be lost among noughts. */
export function length(value: number): string {
  return value !== 0 && Math.abs(value) < 1e-3 ? value.toExponential(1).replace("e-", "e−") : String(Number(value.toPrecision(2)));
}

export function bytes(count: number): string {
  if (count < 1000) return `${count} B`;
  if (count < 1_000_000) return `${(count / 1000).toFixed(1)} kB`;
  return `${(count / 1_000_000).toFixed(1)} MB`;
}

/** A share of 1 in per cent. What is little is not nothing, and nearly all not all. */
export function share(value: number | null): string {
  if (value === null) return MISSING;
  const percent = (100 * value).toFixed(1);
  if (value > 0 && percent === "0.0") return "< 0.1 %";
  if (value < 1 && percent === "100.0") return "> 99.9 %";
  return `${percent} %`;
}

/** A probability; one too small to tell is said to be below what four digits tell. */
export function probability(value: number | null | undefined): string {
  if (value === null || value === undefined) return MISSING;
  return value < 0.0001 ? "< 0.0001" : value.toFixed(4);
}
