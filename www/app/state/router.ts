// Which page is shown: `?page=…`. Shared results, which links keep in the fragment, hold on every page.

import { signal } from "@preact/signals";
import { isShared } from "./fragment";

export const HOME = "score";

/** What one page alone puts into the address. */
const OF_ONE_PAGE = ["step", "method", "set"];

function fromAddress(): string {
  return new URLSearchParams(location.search).get("page") ?? HOME;
}

export const page = signal(fromAddress());

/** Follows the browser's own way back and forth. */
export function heedHistory(): void {
  addEventListener("popstate", () => {
    page.value = fromAddress();
  });
}

/** The address of a page, with everything else of the present address kept but what belongs to the page that is left. */
export function addressOf(id: string): string {
  const query = new URLSearchParams(location.search);
  for (const name of OF_ONE_PAGE) query.delete(name);
  if (id === HOME) query.delete("page");
  else query.set("page", id);
  const search = query.size > 0 ? `?${query}` : "";
  const fragment = id === page.value || isShared(location.hash) ? location.hash : "";
  return `${location.pathname}${search}${fragment}`;
}

export function goTo(id: string): void {
  if (id === page.value) return;
  history.pushState(null, "", addressOf(id));
  page.value = id;
}
