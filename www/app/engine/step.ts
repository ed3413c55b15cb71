// The page's way to what reads and writes STEP, fetched when it is first asked for.

import script from "../../worker/step?worker&url";
import type { StepWorker } from "../../worker/step";
import { LiveWorker } from "./live-worker";
import { startWorker } from "./own-script";

/** A worker for one file; whoever asks for it ends it. */
export function stepWorker(): LiveWorker<StepWorker> {
  return new LiveWorker<StepWorker>((name) => startWorker(script, name), { title: "What reads and writes STEP" });
}
