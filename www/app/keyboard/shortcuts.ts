// The keys of the page. One list makes them work and fills the sheet that explains them.

import { remembered } from "../state/settings";

export interface Shortcut {
  /** As `KeyboardEvent.key` has it. */
  readonly key: string;
  /** As shown; the key itself unless given. */
  readonly shown?: string;
  readonly what: string;
  readonly run: () => void;
}

export interface ShortcutGroup {
  readonly title: string;
  readonly shortcuts: readonly Shortcut[];
}

/** Single keys get in the way of speech input and some aids, so they can be switched off. */
export const keysOn = remembered("keys", "on", ["on", "off"] as const);

export function listen(groups: readonly ShortcutGroup[]): void {
  window.addEventListener("keydown", (event) => {
    if (keysOn.value === "off" && event.key !== "Escape") return;
    if (event.defaultPrevented || event.ctrlKey || event.metaKey || event.altKey || isTyping(event)) return;
    if (document.querySelector("dialog[open], :popover-open")) return;
    const found = groups.flatMap(({ shortcuts }) => shortcuts).find(({ key }) => key === event.key);
    if (!found) return;
    event.preventDefault();
    found.run();
  });
}

function isTyping({ target, key }: KeyboardEvent): boolean {
  // In a slider or a box to tick there is nothing that Escape would take back.
  if (key === "Escape" && target instanceof Element && target.matches("input:is([type=range], [type=checkbox], [type=radio])")) return false;
  return target instanceof HTMLElement && (target.isContentEditable || target.matches("input, textarea, select"));
}
