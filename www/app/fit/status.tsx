// The fit under way, at the foot of the page: seen and heard whatever panel is shown.

import type { JSX } from "preact";
import { computed } from "@preact/signals";
import { cancelFitting, fitProgress, fitRun, methodsOf } from "../state/fitting";
import { duration, integer } from "../ui/format";

/** With less than this done, the time left is anybody's guess. */
const LEAST_SHARE = 0.05;

/** Changes seldom enough to be read out: at each stage of a single fit, else at each model done. */
const heard = computed(() => {
  const progress = fitProgress.value;
  const run = fitRun.value;
  if (!progress || !run) return "";
  const [only] = run.fits;
  if (only && progress.total === 1) {
    const state = only.state.value;
    return `${methodsOf(run)} fits ${only.model}: ${state.kind === "running" ? state.stage : "waiting"}`;
  }
  return `${methodsOf(run)}: ${integer(progress.done)} of ${integer(progress.total)} fits done`;
});

/** `stoppable` is false where something else on the page stops it, with more. */
export function FittingWork({ stoppable }: { stoppable: boolean }): JSX.Element {
  const progress = fitProgress.value;
  return (
    <>
      <p class="visually-hidden" role="status">
        {heard.value}
      </p>
      {progress && (
        <div class="work">
          {stoppable && (
            <button type="button" onClick={cancelFitting}>
              Stop fitting
            </button>
          )}
          <progress id="fitting" max={1} value={progress.share} />
          <label for="fitting">
            {progress.total === 1 ? heard.value : `Fitting ${integer(progress.done)} of ${integer(progress.total)}`}
            {remaining(progress)}
          </label>
        </div>
      )}
    </>
  );
}

function remaining({ share, since }: { share: number; since: number }): string {
  if (share < LEAST_SHARE) return "";
  return `, ${duration(((performance.now() - since) / share) * (1 - share))} left`;
}
