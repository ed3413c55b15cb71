// What the reader has chosen, kept for the next visit where the browser allows it.

import { batch, effect, signal, type Signal } from "@preact/signals";
import { PROTOCOLS } from "../../generated/declared/protocols.js";
import type { Protocol } from "../engine/contract";

export type Theme = "system" | "light" | "dark";

const PREFIX = "fit4cad.";

interface Remembered {
  readonly key: string;
  readonly value: Signal<string>;
}

const all: Remembered[] = [];
let keeping = false;

/** A signal that remembers its value, once `keepSettings` was called. Storage may be forbidden or full: then it just does not. */
export function remembered<T extends string>(key: string, initial: T, allowed: readonly T[]): Signal<T> {
  const value = signal(read(key, initial, allowed));
  const setting = { key, value: value as unknown as Signal<string> };
  all.push(setting);
  if (keeping) keep(setting);
  return value;
}

/** Keeps what is chosen from now on, also in parts of the page that are loaded later. */
export function keepSettings(): void {
  keeping = true;
  all.forEach(keep);
}

function keep({ key, value }: Remembered): void {
  effect(() => {
    const current = value.value;
    if (lent.get(value)?.shown === current) return;
    lent.delete(value);
    try {
      localStorage.setItem(PREFIX + key, current);
    } catch {
      // Nothing depends on it being kept.
    }
  });
}

/** What is shown for the time being, and what the reader had chosen. */
const lent = new Map<unknown, { readonly shown: string; readonly giveBack: () => void }>();

/** Sets a setting to what a link shows with, until the reader chooses anew or it is taken back. It is not remembered. */
export function lend<T extends string>(setting: Signal<T>, to: T): void {
  const own = setting.peek();
  const giveBack = lent.get(setting)?.giveBack ?? (() => (setting.value = own));
  lent.set(setting, { shown: to, giveBack });
  setting.value = to;
}

/** Sets everything that was lent, and not chosen anew since, to what the reader had chosen. */
export function takeBack(): void {
  const loans = [...lent.values()];
  batch(() => loans.forEach(({ giveBack }) => giveBack()));
  lent.clear();
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
export const protocol = remembered<Protocol>("protocol", "definition", PROTOCOLS.map(({ name }) => name));

const NEXT_THEME: Readonly<Record<Theme, Theme>> = { system: "light", light: "dark", dark: "system" };

export function nextTheme(): void {
  theme.value = NEXT_THEME[theme.value];
}

const systemDark = matchMedia("(prefers-color-scheme: dark)");
const systemIsDark = signal(systemDark.matches);

/** Whether the page is dark right now. */
export function isDark(): boolean {
  return theme.value === "system" ? systemIsDark.value : theme.value === "dark";
}

/** Has the page in the chosen theme, or in the system's. */
export function applyTheme(): void {
  systemDark.addEventListener("change", (event) => {
    systemIsDark.value = event.matches;
  });
  effect(() => {
    document.documentElement.dataset["theme"] = isDark() ? "dark" : "light";
  });
}
