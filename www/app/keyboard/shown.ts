// Whether the sheet that lists the keys is open.

import { signal } from "@preact/signals";

export const keysShown = signal(false);
