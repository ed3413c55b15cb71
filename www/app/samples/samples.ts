// Parts made by the engine, with true ground truth and a submission that is imperfect on purpose.

import { PARTS } from "../../generated/declared/parts.js";
import { engine } from "../engine/client";
import type { SampleOptions } from "../engine/contract";
import { addMade, keepMade, type Entrance } from "../state/arrivals";
import { models } from "../state/models";
import { notify } from "../state/notices";
import { isSameSample, nameOfSample, type SampleOrigin } from "./identity";

/** Has a sample on the page, made anew unless it is there. Says so where it cannot be made. */
export async function makeSample(part: string, options: SampleOptions, how: Entrance = "shown", stopped?: AbortSignal): Promise<void> {
  const origin = { kind: "sample", part, options } as const;
  if (keepIfHere(origin, how)) return;
  try {
    const name = nameOfSample(origin);
    const { files } = await engine.run(
      (api) => (how === "opening" ? api.opening(name) : api.generate(part, options, name)),
      stopped ? { signal: stopped } : {},
    );
    // It may have been asked for twice.
    if (!keepIfHere(origin, how)) addMade(name, origin, files, how);
  } catch (error) {
    if (stopped?.aborted) return;
    notify(`The sample could not be made: ${error instanceof Error ? error.message : String(error)}`, "error");
  }
}

/** Keeps the sample where it is on the page already; the result is whether it is. */
function keepIfHere(origin: SampleOrigin, how: Entrance): boolean {
  const known = models.value.find((entry) => isSameSample(entry.origin, origin));
  if (known) keepMade(known.id, how);
  return known !== undefined;
}

/** Puts the first part on the page, so that there is something to see from the start. */
export async function openFirstSample(): Promise<void> {
  const [first] = PARTS;
  if (first) await makeSample(first.name, {}, "opening");
}
