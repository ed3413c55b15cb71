// What to fit with: the method, its parameters and the seed.

import { computed, signal } from "@preact/signals";
import { FITTERS } from "../../generated/declared/fitters.js";
import type { FitMethod } from "../engine/contract";
import type { FitRequest } from "../../worker/protocol";

export const DEFAULT_SEED = 1;

export const method = signal<FitMethod>("ht");
export const seed = signal(DEFAULT_SEED);

/** Values other than the default, by method and parameter. */
const changed = signal<Readonly<Partial<Record<FitMethod, Readonly<Record<string, number>>>>>>({});

/** Those of the chosen method. */
const own = computed(() => changed.value[method.value] ?? {});

/** What the chosen method is. */
export const fitter = computed(() => FITTERS.find(({ name }) => name === method.value));

export const request = computed<FitRequest>(() => ({
  method: method.value,
  parameters: own.value,
  seed: seed.value,
}));

export const anyChanged = computed(() => Object.keys(own.value).length > 0 || seed.value !== DEFAULT_SEED);

/** The value set, or undefined where the default holds. */
export function valueOf(name: string): number | undefined {
  return own.value[name];
}

/** Sets a parameter of the chosen method; undefined takes its default back. */
export function setParameter(name: string, value: number | undefined): void {
  const { [name]: _, ...others } = own.value;
  const values = value === undefined ? others : { ...others, [name]: value };
  changed.value = { ...changed.value, [method.value]: values };
}

/** Takes every default of the chosen method back. */
export function resetAll(): void {
  changed.value = { ...changed.value, [method.value]: {} };
  seed.value = DEFAULT_SEED;
}
