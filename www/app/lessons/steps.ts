// Which step of a lesson is shown: `&step=…`, counted from 1.

import { signal } from "@preact/signals";

function fromAddress(): number {
  const asked = Number(new URLSearchParams(location.search).get("step") ?? 1);
  return Number.isInteger(asked) && asked > 0 ? asked : 1;
}

export const step = signal(fromAddress());

addEventListener("popstate", () => {
  step.value = fromAddress();
});

/** The address may name another lesson by now, or a step that there is not. */
export function readStep(last: number): void {
  step.value = Math.min(fromAddress(), last);
}

export function goToStep(to: number, last: number): void {
  const next = Math.min(Math.max(to, 1), last);
  if (next === step.value) return;
  const query = new URLSearchParams(location.search);
  query.set("step", String(next));
  history.pushState(null, "", `${location.pathname}?${query}${location.hash}`);
  step.value = next;
}
