// Parts made by the engine, with true ground truth and a submission that is imperfect on purpose.

import { signal } from "@preact/signals";
import { engine } from "../engine/client";
import type { SampleOptions, PartInfo } from "../engine/contract";
import { addMade, keepMade, type Entrance } from "../state/inbox";
import { models } from "../state/models";
import { notify } from "../state/notices";
import { isSameSample, nameOfSample, type SampleOrigin } from "./identity";

export const partList = signal<readonly PartInfo[]>([]);

let listed: Promise<void> | undefined;

/** Asks the engine once which parts it can make. */
export function listParts(): Promise<void> {
  listed ??= engine.run((api) => api.parts()).then((parts) => void (partList.value = parts));
  return listed;
}

/** Has a sample on the page, made anew unless it is there. Says so where it cannot be made. */
export async function makeSample(part: string, options: SampleOptions, how: Entrance = "shown", stopped?: AbortSignal): Promise<void> {
  const origin = { kind: "sample", part, options } as const;
  if (keepIfHere(origin, how)) return;
  try {
    const name = nameOfSample(origin);
    const { files } = await engine.run((api) => api.generate(part, options, name), stopped ? { signal: stopped } : {});
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
  await listParts();
  const first = partList.value[0];
  if (first) await makeSample(first.name, {}, "opening");
}
