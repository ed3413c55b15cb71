// Importing a STEP file again, in another way, in the place of the model it was.

import { batch } from "@preact/signals";
import type { HowImported } from "../../worker/step";
import { importPart, summaryOf } from "../intake/step";
import { bring } from "../state/inbox";
import { forget } from "../state/made";
import { notify } from "../state/notices";
import type { StepSource } from "../state/origin";

/** @throws words for the reader; then the model stays as it is. */
export async function importAgain(id: string, step: StepSource, how: HowImported, stop: AbortController): Promise<void> {
  const { files, report } = await importPart({ path: step.path, data: step.data }, how, stop);
  await batch(() => {
    // What was fitted names points that are no more.
    forget(id);
    return bring(files, []);
  });
  notify(`${step.path}: ${summaryOf(report)}`);
}
