// Sums of figures that are shown in one place alone.

import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { scoresOf, type Scored } from "../../shared/formats/measures.mjs";
import { engine } from "../engine/client";
import type { MethodSummary } from "../engine/contract";

/** Each method's means over the reports, once the engine has answered; asked anew for other reports. */
export function useSummaries(reports: readonly Scored[]): readonly MethodSummary[] {
  const summaries = useSignal<readonly MethodSummary[]>([]);
  useEffect(() => {
    let current = true;
    const show = (found: readonly MethodSummary[]) => {
      if (current) summaries.value = found;
    };
    const scores = scoresOf(reports);
    engine.run((api) => api.summarise(scores)).then(show, () => show([]));
    return () => {
      current = false;
    };
  }, [reports]);
  return summaries.value;
}
