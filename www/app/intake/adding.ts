// Whether the sheet is open that brings data.

import { signal } from "@preact/signals";

export const adding = signal(false);
