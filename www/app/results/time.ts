// How long a method takes for a cloud: as measured model by model, else as its authors say.

import { summaryOf, type Row } from "./table-data";

export interface Time {
  readonly seconds: number;
  readonly text: string;
  /** What of many clouds it is. */
  readonly what: "median" | "mean, as published";
  readonly platform: "wasm" | "native";
  readonly machine: string;
}

export function timeOf(row: Row, set: string): Time | undefined {
  const said = row.method.time;
  if (!said) return undefined;
  const { platform, machine } = said;
  const spread = summaryOf(row, set)?.seconds;
  if (spread) return { seconds: spread.median, text: secondsText(spread.median), what: "median", platform, machine };
  if (said.seconds === undefined) return undefined;
  const source = said.source === undefined ? "" : ` (${said.source})`;
  return { seconds: said.seconds, text: secondsText(said.seconds), what: "mean, as published", platform, machine: machine + source };
}

/** Two digits tell enough of what another machine would take. */
export function secondsText(seconds: number): string {
  return seconds >= 100 ? seconds.toFixed(0) : String(Number(seconds.toPrecision(2)));
}
