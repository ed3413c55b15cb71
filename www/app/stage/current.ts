// The view that is on the page, and whether the sheet that saves a picture of it is open.

import { signal } from "@preact/signals";
import type { PointView } from "../view/point-view";

/** Nothing until it is there. */
export const currentView = signal<PointView | undefined>(undefined);

export const picturing = signal(false);
