// Which panel under the views is shown.

import { signal } from "@preact/signals";
import { tables } from "./extent";

export const shownPanel = signal("measures");

/** What the tab of a panel is called in the document. */
export function tabOf(id: string): string {
  return `tab-${id}`;
}

/** Shows a panel, also where the tables were folded. */
export function showPanel(id: string): void {
  shownPanel.value = id;
  tables.value = "open";
}

/** Shows a panel and goes there, also where it is below the edge of a small window. */
export function goToPanel(id: string): void {
  showPanel(id);
  const tab = document.getElementById(tabOf(id));
  tab?.focus({ preventScroll: true });
  tab?.scrollIntoView({ block: "start", inline: "nearest" });
}
