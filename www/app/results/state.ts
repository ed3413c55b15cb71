// What is looked at of the standing table: the page's address names the set and the method.

import { computed, signal } from "@preact/signals";
import { PROTOCOLS } from "../measures/protocols";
import { protocol, remembered } from "../state/settings";
import type { ViewName } from "./columns";
import { SETS, setOf } from "./table-data";

function asked(name: string): string | undefined {
  return new URLSearchParams(location.search).get(name) ?? undefined;
}

function askedSet(): string {
  const named = asked("set") ?? "";
  return setOf(named)?.id ?? SETS[0]?.id ?? "";
}

export const shownSet = signal(askedSet());
/** The method whose own page is shown. */
export const shownMethod = signal(asked("method"));

/** The measures are shown by the protocol that holds on the whole page. */
const MEASURES = "measures";
type Group = Exclude<ViewName, (typeof PROTOCOLS)[number]["name"]> | typeof MEASURES;

const group = remembered<Group>("results", MEASURES, [MEASURES, "protocols", "fit", "wear"]);

export const view = computed<ViewName>(() => (group.value === MEASURES ? protocol.value : group.value));

export function showView(name: ViewName): void {
  const chosen = PROTOCOLS.find((each) => each.name === name)?.name;
  if (chosen) protocol.value = chosen;
  group.value = chosen ? MEASURES : (name as Group);
}

/** Follows the address until the result is called. */
export function heedAddress(): () => void {
  const heed = () => {
    shownSet.value = askedSet();
    shownMethod.value = asked("method");
  };
  heed();
  addEventListener("popstate", heed);
  return () => removeEventListener("popstate", heed);
}

/** The address of a method's page, or of the table where none is given; relative to the page's own. */
export function addressOfMethod(id: string | undefined, set: string = shownSet.value): string {
  const query = new URLSearchParams(location.search);
  query.delete("method");
  query.delete("set");
  if (!query.has("embed")) query.set("page", "results");
  if (id !== undefined) query.set("method", id);
  if (set !== SETS[0]?.id) query.set("set", set);
  return `${location.pathname}?${query}`;
}

export function showMethod(id: string | undefined): void {
  history.pushState(null, "", addressOfMethod(id));
  shownMethod.value = id;
  document.getElementById("content")?.scrollIntoView();
}

/** A set is looked at, not gone to: the way back leads to where the reader was before. */
export function showSet(id: string): void {
  history.replaceState(null, "", addressOfMethod(shownMethod.value, id));
  shownSet.value = id;
}
