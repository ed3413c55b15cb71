// Where the view looks from, for links.

import { signal } from "@preact/signals";
import type { CameraState } from "../view/types";

/** Where the camera last came to rest, fit for a view of any shape. */
export const restingCamera = signal<CameraState | undefined>(undefined);

/** A camera to be taken up as soon as its model is in view. */
export const awaitedCamera = signal<{ readonly model: string; readonly state: CameraState } | undefined>(undefined);
