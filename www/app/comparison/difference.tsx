// A difference with its sign, a mark and a colour: none of the three alone has to tell.

import type { JSX } from "preact";
import type { Difference, Measure } from "../engine/contract";
import * as format from "../ui/format";

const MARKS: Readonly<Record<Difference["outcome"], string>> = { better: "▲", worse: "▼", even: "=" };

export function DifferenceMark({ measure, difference }: { measure: Measure; difference: Difference | null | undefined }): JSX.Element {
  if (!difference) return <>{format.MISSING}</>;
  const { by, outcome } = difference;
  return (
    <span class="difference" data-outcome={outcome}>
      {outcome === "even" ? "0" : `${by > 0 ? "+" : "−"}${format.measure(measure, Math.abs(by))}`}{" "}
      <span aria-hidden="true">{MARKS[outcome]}</span>
      <span class="visually-hidden">{outcome}</span>
    </span>
  );
}
