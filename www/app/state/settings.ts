// What the reader has chosen, kept for the next visit where the browser allows it.

import { effect, signal, type Signal } from "@preact/signals";
import type { Protocol } from "../engine/contract";

export type Theme = "system" | "light" | "dark";

const PREFIX = "fit4cad.";

/** A signal that remembers its value. Storage may be forbidden or full: then it just does not. */
export function remembered<T extends string>(key: string, initial: T, allowed: readonly T[]): Signal<T> {
  const value = signal(read(key, initial, allowed));
  effect(() => {
    const current = value.value;
    try {
      localStorage.setItem(PREFIX + key, current);
    } catch {
      // Nothing depends on it being kept.
    }
  });
  return value;
}

function read<T extends string>(key: string, initial: T, allowed: readonly T[]): T {
  try {
    const kept = localStorage.getItem(PREFIX + key);
    return allowed.find((value) => value === kept) ?? initial;
  } catch {
    return initial;
  }
}

export const theme = remembered<Theme>("theme", "system", ["system", "light", "dark"]);
export const protocol = remembered<Protocol>("protocol", "definition", ["definition", "published"]);

const systemDark = matchMedia("(prefers-color-scheme: dark)");
const systemIsDark = signal(systemDark.matches);
systemDark.addEventListener("change", (event) => {
  systemIsDark.value = event.matches;
});

/** Whether the page is dark right now. */
export function isDark(): boolean {
  return theme.value === "system" ? systemIsDark.value : theme.value === "dark";
}

effect(() => {
  document.documentElement.dataset["theme"] = isDark() ? "dark" : "light";
});
