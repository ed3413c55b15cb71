// Which models were made of STEP files.

import { computed } from "@preact/signals";
import { contents, type Content } from "./contents";
import { brought } from "./inbox";
import type { StepSource } from "./origin";

/** The STEP file that a model was made of. */
export function stepOf({ source }: Content): StepSource | undefined {
  const cloud = source.files.find(({ role }) => role === "cloud");
  return cloud && brought.value.get(cloud.path)?.step;
}

/** The models that were made of STEP files. */
export const madeOfStep = computed<readonly Content[]>(() => contents.value.filter((content) => stepOf(content) !== undefined));

/** Whether there is one. */
export const anyStep = computed(() => madeOfStep.value.length > 0);

/** The panel with the faces of such a model. */
export const CAD_PANEL = "cad";
