// What the reader looks at, as plain data: read off the page, and shown on it.

import { batch } from "@preact/signals";
import { awaitedCamera, restingCamera } from "../stage/camera";
import { COLOUR_MODES } from "../stage/colouring";
import { arrangement, ARRANGEMENTS, colourMode, projection } from "../stage/display";
import { leftShows, rightIsTruth, selectedMethod, selectedModel, selectedPrimitive, selectModel, showLeft } from "../state/selection";
import { lend } from "../state/settings";
import type { Look } from "./kinds/view";

export function looking(): Look | undefined {
  const model = selectedModel.peek();
  if (model === undefined) return undefined;
  const [method, left, primitive, camera] = [selectedMethod.peek(), leftShows.peek(), selectedPrimitive.peek(), restingCamera.peek()];
  return {
    model,
    ...(method !== undefined && { method }),
    ...(left !== undefined && { left }),
    ...(rightIsTruth.peek() && { rightIsTruth: true }),
    ...(primitive && { primitive }),
    ...(camera && { camera }),
    colour: colourMode.peek(),
    arrangement: arrangement.peek(),
  };
}

/** Shows it; at the submissions alone, without a jump of the camera. The reader's own settings are kept for later visits. */
export function look({ model, method, left, primitive, camera, ...rest }: Look, what: "everything" | "submissions"): void {
  batch(() => {
    selectModel(model, method);
    showLeft(left);
    rightIsTruth.value = rest.rightIsTruth ?? false;
    selectedPrimitive.value = primitive;
    if (what === "submissions") return;
    colourMode.value = COLOUR_MODES.find(({ id }) => id === rest.colour)?.id ?? colourMode.value;
    const arranged = ARRANGEMENTS.find(({ id }) => id === rest.arrangement)?.id;
    if (arranged) lend(arrangement, arranged);
    if (!camera) return;
    lend(projection, camera.projection);
    awaitedCamera.value = { model, state: camera };
  });
}
