// How much of the page the picture has: shared with the tables, all but their tabs, or all of it.

import { signal } from "@preact/signals";
import { remembered } from "./settings";

/** Whether nothing but the picture is shown, until Escape. */
export const alone = signal(false);

/** Whether of the panels there are the tabs alone. */
export const tables = remembered("tables", "open", ["open", "folded"] as const);

export function toggleAlone(): void {
  alone.value = !alone.value;
}

export function toggleTables(): void {
  tables.value = tables.value === "open" ? "folded" : "open";
}
