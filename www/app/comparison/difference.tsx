// A difference with its sign, a mark and a colour: none of the three alone has to tell.

import type { JSX } from "preact";
import type { Measure } from "../engine/contract";
import { MEASURE_TEXT } from "../measures/measures";
import * as format from "../ui/format";
import { difference, outcome, type Outcome, type Pair } from "./compare";

const MARKS: Readonly<Record<Outcome, string>> = { better: "▲", worse: "▼", even: "=" };

export function DifferenceMark({ measure, pair }: { measure: Measure; pair: Pair }): JSX.Element {
  const by = difference(pair);
  const result = outcome(pair, MEASURE_TEXT[measure].good);
  if (by === null || result === null) return <>{format.MISSING}</>;
  return (
    <span class="difference" data-outcome={result}>
      {result === "even" ? "0" : `${by > 0 ? "+" : "−"}${format.measure(measure, Math.abs(by))}`}{" "}
      <span aria-hidden="true">{MARKS[result]}</span>
      <span class="visually-hidden">{result}</span>
    </span>
  );
}
