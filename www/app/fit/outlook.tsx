// What is told beside the button that begins a fit: how long it will take.

import type { JSX } from "preact";
import { computed } from "@preact/signals";
import { WORKERS } from "../engine/client";
import { fitProgress, fitsDone, titleOf } from "../state/fitting";
import { modelById, models, pointsOf, type ModelEntry } from "../state/models";
import { selectedModel } from "../state/selection";
import { integer, plural } from "../ui/format";
import { estimate, LONG_SECONDS, pointsFitted, proposal, range, together, type Estimate } from "./estimate";
import { method, request } from "./settings";

/** What is asked for: a fit of the model's points, or of so many of them. */
function asked(entry: ModelEntry | undefined) {
  const points = pointsOf(entry);
  return entry && points !== undefined ? { method: method.value, model: entry.id, points: pointsFitted(points, request.value) } : undefined;
}

function of(entry: ModelEntry): Estimate | undefined {
  const wanted = asked(entry);
  return wanted && estimate(wanted, fitsDone.value);
}

/** A smaller fit of the selected model, where that of all its points may take minutes. */
export const smaller = computed(() => {
  const wanted = asked(modelById(selectedModel.value));
  return wanted && !fitProgress.value ? proposal(wanted, fitsDone.value) : undefined;
});

const all = computed(() => {
  const known = models.value.flatMap((entry) => of(entry) ?? []);
  return { count: known.length, estimate: together(known, WORKERS) };
});

export function Outlook(): JSX.Element | null {
  // From then on the foot of the page tells how much is left.
  if (fitProgress.value) return null;
  const entry = modelById(selectedModel.value);
  const points = asked(entry)?.points;
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
      {smaller.value && ` ${integer(smaller.value.points)} of them take ${range(smaller.value.estimate)}; all points are labelled by what is found.`}
    </p>
  );
}
