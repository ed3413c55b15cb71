// Parts made by the engine, with true ground truth and a submission that is imperfect on purpose.

import { signal } from "@preact/signals";
import { engine } from "../engine/client";
import type { SampleOptions, PartInfo } from "../engine/contract";
import { addMade, type Entrance } from "../state/inbox";
import { notify } from "../state/notices";

export const partList = signal<readonly PartInfo[]>([]);

let listed: Promise<void> | undefined;

/** Asks the engine once which parts it can make. */
export function listParts(): Promise<void> {
  listed ??= engine.run((api) => api.parts()).then((parts) => void (partList.value = parts));
  return listed;
}

export async function makeSample(part: string, options: SampleOptions, how: Entrance = "shown"): Promise<void> {
  try {
    const { name, files } = await engine.run((api) => api.generate(part, options));
    addMade(name, { kind: "sample", part, options }, files, how);
  } catch (error) {
    notify(`The sample could not be made: ${error instanceof Error ? error.message : String(error)}`, "error");
  }
}

/** Puts the first part on the page, so that there is something to see from the start. */
export async function openFirstSample(): Promise<void> {
  await listParts();
  const first = partList.value[0];
  if (first) await makeSample(first.name, {}, "opening");
}
