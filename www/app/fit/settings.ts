// What to fit with: the method, its parameters and the seed.

import { computed, signal } from "@preact/signals";
import { engine } from "../engine/client";
import type { FitMethod, ParameterInfo } from "../engine/contract";
import type { FitRequest } from "../../worker/protocol";

export const METHODS: readonly { readonly id: FitMethod; readonly title: string; readonly about: string }[] = [
  {
    id: "ht",
    title: "HT",
    about: "Hough transform: points vote for surfaces in the space of their parameters; persistent peaks become primitives.",
  },
  {
    id: "pg",
    title: "PG",
    about: "Primitive growing: smooth regions grow from neighbourhoods, and slippage tells what surface each lies on.",
  },
];

export const DEFAULT_SEED = 1;

export const method = signal<FitMethod>("ht");
export const seed = signal(DEFAULT_SEED);

/** The engine's tables, by method, once they are there. */
const tables = signal<Readonly<Partial<Record<FitMethod, readonly ParameterInfo[]>>>>({});

/** Values other than the default, by method and parameter. */
const changed = signal<Readonly<Record<FitMethod, Readonly<Record<string, number>>>>>({ ht: {}, pg: {} });

export const parameters = computed<readonly ParameterInfo[] | undefined>(() => tables.value[method.value]);

export const request = computed<FitRequest>(() => ({
  method: method.value,
  parameters: changed.value[method.value],
  seed: seed.value,
}));

export const anyChanged = computed(() => Object.keys(changed.value[method.value]).length > 0 || seed.value !== DEFAULT_SEED);

let asked: Promise<void> | undefined;

/** Asks the engine once for the parameters of both methods. */
export function loadParameters(): Promise<void> {
  asked ??= engine
    .run(async (api) => ({ ht: await api.fitParameters("ht"), pg: await api.fitParameters("pg") }))
    .then((both) => void (tables.value = both));
  return asked;
}

/** The value set, or undefined where the default holds. */
export function valueOf(name: string): number | undefined {
  return changed.value[method.value][name];
}

/** Sets a parameter of the chosen method; undefined takes its default back. */
export function setParameter(name: string, value: number | undefined): void {
  const { [name]: _, ...others } = changed.value[method.value];
  const values = value === undefined ? others : { ...others, [name]: value };
  changed.value = { ...changed.value, [method.value]: values };
}

/** Takes every default of the chosen method back. */
export function resetAll(): void {
  changed.value = { ...changed.value, [method.value]: {} };
  seed.value = DEFAULT_SEED;
}
