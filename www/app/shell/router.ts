// Which page is shown: `?page=…`. Shared results, which links keep in the fragment, hold on every page.

import { signal } from "@preact/signals";
import { isShared } from "../sharing/fragment";
import type { Load } from "../ui/lazy";

export interface PageDefinition {
  readonly id: string;
  readonly title: string;
  readonly load: Load;
  /** The page whose link stands for this one in the header. */
  readonly under?: string;
  /** Whether it is about the models on the page: only then does a first visit find a sample there. */
  readonly showsModels?: true;
}

export const HOME = "score";

function fromAddress(): string {
  return new URLSearchParams(location.search).get("page") ?? HOME;
}

export const page = signal(fromAddress());

addEventListener("popstate", () => {
  page.value = fromAddress();
});

/** The address of a page, with everything else of the present address kept but what belongs to the page that is left. */
export function addressOf(id: string): string {
  const query = new URLSearchParams(location.search);
  query.delete("step");
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
