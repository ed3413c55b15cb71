// Which page is shown: `?page=…`. The fragment is left alone; links keep results there.

import { signal } from "@preact/signals";
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

/** The address of a page, with everything else of the present address kept but the step of a lesson. */
export function addressOf(id: string): string {
  const query = new URLSearchParams(location.search);
  query.delete("step");
  if (id === HOME) query.delete("page");
  else query.set("page", id);
  const search = query.size > 0 ? `?${query}` : "";
  return `${location.pathname}${search}${location.hash}`;
}

export function goTo(id: string): void {
  if (id === page.value) return;
  history.pushState(null, "", addressOf(id));
  page.value = id;
}
