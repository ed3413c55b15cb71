// Progress and short messages, at the foot of the page and announced.

import type { JSX } from "preact";
import { useComputed, useSignal, useSignalEffect } from "@preact/signals";
import { ImportingWork } from "../cad/status";
import { FittingWork } from "../fit/status";
import { DownloadProgress } from "../public/progress";
import { taking } from "../intake/intake";
import { importing } from "../intake/step";
import { rebuilding } from "../sharing/state";
import { dismiss, notice } from "../state/notices";
import { cancelScoring, progress, reading, type Progress } from "../state/scoring";
import { duration, integer } from "../ui/format";
import { Icon } from "../ui/icon";

/** A batch shorter than this is over before anybody could read about it. */
const SHOW_AFTER_MS = 250;

export function StatusBar(): JSX.Element {
  const shown = notice.value;
  return (
    <footer class="status">
      <DownloadProgress id="downloading" />
      <Work />
      <ImportingWork />
      <FittingWork stoppable={rebuilding.value === undefined} />
      <p class="notice" role="status" data-kind={shown?.kind}>
        {shown?.text}
        {shown?.offer && (
          <button
            type="button"
            onClick={() => {
              // What it does may have something to say.
              dismiss();
              shown.offer?.run();
            }}
          >
            {shown.offer.title}
          </button>
        )}
        {shown && (
          <button type="button" class="icon" aria-label="Dismiss the message" onClick={dismiss}>
            <Icon name="close" />
          </button>
        )}
      </p>
    </footer>
  );
}

function Work(): JSX.Element | null {
  const late = useSignal(false);
  const busy = useComputed(() => progress.value !== undefined || taking.value);
  useSignalEffect(() => {
    if (!busy.value) {
      late.value = false;
      return;
    }
    const timer = setTimeout(() => (late.value = true), SHOW_AFTER_MS);
    return () => clearTimeout(timer);
  });
  const batch = progress.value;
  if (batch && (late.value || batch.total > 1)) return <Batch {...batch} />;
  if (taking.value && late.value && !importing.value) {
    return (
      <div class="work">
        <label for="taking">Reading files…</label>
        <progress id="taking" />
      </div>
    );
  }
  return null;
}

/** A file without its folders. */
function nameOf(path: string): string {
  return path.slice(path.lastIndexOf("/") + 1);
}

function Batch({ done, total, since }: Progress): JSX.Element {
  const left = done > 0 ? ((performance.now() - since) / done) * (total - done) : undefined;
  // Every figure read out would drown everything else.
  const quarters = Math.floor((4 * done) / total);
  return (
    <div class="work">
      <button type="button" onClick={cancelScoring}>
        Stop
      </button>
      <progress id="scoring" max={total} value={done} />
      <label for="scoring">
        Scoring {integer(done)} of {integer(total)}
        {left !== undefined && `, ${duration(left)} left`}
        {reading.value && `, reading ${nameOf(reading.value.path)}, ${Math.round(100 * reading.value.share)} %`}
      </label>
      <span class="visually-hidden" role="status">
        Scoring, {25 * quarters} % done
      </span>
    </div>
  );
}
