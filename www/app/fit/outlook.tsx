// What is told beside the button that begins a fit: how long it will take.

import type { JSX } from "preact";
import { computed } from "@preact/signals";
import { WORKERS } from "../engine/client";
import { fitProgress, fitsDone, titleOf } from "../state/fitting";
import { modelById, models, pointsOf, type ModelEntry } from "../state/models";
import { selectedModel } from "../state/selection";
import { integer, plural } from "../ui/format";
import { estimate, range, together, type Estimate } from "./estimate";
import { method } from "./settings";

/** Who waits as long as this wants to know that there is no need to. */
const LONG_SECONDS = 60;

function of(entry: ModelEntry): Estimate | undefined {
  const points = pointsOf(entry);
  return points === undefined ? undefined : estimate({ method: method.value, model: entry.id, points }, fitsDone.value);
}

const all = computed(() => {
  const known = models.value.flatMap((entry) => of(entry) ?? []);
  return { count: known.length, estimate: together(known, WORKERS) };
});

export function Outlook(): JSX.Element | null {
  // From then on the foot of the page tells how much is left.
  if (fitProgress.value) return null;
  const entry = modelById(selectedModel.value);
  const points = pointsOf(entry);
  const own = entry && of(entry);
  if (!own || points === undefined) return null;
  const { count, estimate: every } = all.value;
  const source = own.fits > 0 ? `by ${plural(own.fits, "fit")} with ${titleOf(method.value)} done here` : "on an ordinary computer";
  return (
    <p class="hint" data-testid="fit-outlook">
      {integer(points)} points take {range(own)}, {source}; the more noise, the longer.
      {count > 1 && ` All ${integer(count)} models: ${range(every)}.`}
      {Math.max(own.to, count > 1 ? every.to : 0) >= LONG_SECONDS &&
        " The page can be used meanwhile, and a fit stopped at any moment."}
    </p>
  );
}
