// What was made here, not brought as files: models, and submissions for any model on the page.

import { batch, computed, signal } from "@preact/signals";
import type { FitRequest, ModelFile } from "../../worker/protocol";
import type { Origin } from "./origin";

export interface MadeModel {
  readonly origin: Origin;
  readonly files: readonly ModelFile[];
  /** Whether it is only there to look at, and goes when the first files are brought. */
  readonly makesRoom: boolean;
}

export interface MadeSubmission {
  readonly files: readonly ModelFile[];
  /** How it was fitted. */
  readonly request: FitRequest;
}

/** The submissions of one model, by their names. */
export type Submissions = ReadonlyMap<string, MadeSubmission>;

/** By their names on the page. */
export const madeModels = signal<ReadonlyMap<string, MadeModel>>(new Map());
/** Whether all that was made here is only there to look at. */
export const onlyOpening = computed(() => [...madeModels.value.values()].every(({ makesRoom }) => makesRoom));
/** By the name of the model they are for. */
export const madeSubmissions = signal<ReadonlyMap<string, Submissions>>(new Map());

/** Whether a submission was made here, not brought. */
export function isMadeHere(name: string, method: string): boolean {
  return (
    madeSubmissions.value.get(name)?.has(method) === true ||
    madeModels.value.get(name)?.files.some((file) => file.method === method) === true
  );
}

/** How a submission was fitted here; nothing for one that was brought. */
export function fitOf(name: string, method: string): FitRequest | undefined {
  return madeSubmissions.value.get(name)?.get(method)?.request;
}

/** Adds a submission to a model; one of the same name is replaced. */
export function putSubmission(name: string, method: string, made: MadeSubmission): void {
  const others = madeSubmissions.value.get(name) ?? new Map<string, MadeSubmission>();
  madeSubmissions.value = new Map(madeSubmissions.value).set(name, new Map(others).set(method, made));
}

/** Takes a submission made here off its model. */
export function removeSubmission(name: string, method: string): void {
  batch(() => {
    const fitted = madeSubmissions.value.get(name);
    if (fitted?.has(method)) {
      madeSubmissions.value = new Map(madeSubmissions.value).set(name, new Map([...fitted].filter(([other]) => other !== method)));
    }
    const model = madeModels.value.get(name);
    if (model?.files.some((file) => file.method === method)) {
      const files = model.files.filter((file) => file.method !== method);
      madeModels.value = new Map(madeModels.value).set(name, { ...model, files });
    }
  });
}

/** Has what was made at an earlier time beside what there is now, which is newer. */
export function putBackMade(models: ReadonlyMap<string, MadeModel>, submissions: ReadonlyMap<string, Submissions>): void {
  batch(() => {
    madeModels.value = new Map([...models, ...madeModels.value]);
    const names = new Set([...submissions.keys(), ...madeSubmissions.value.keys()]);
    const both = (name: string) => [...(submissions.get(name) ?? []), ...(madeSubmissions.value.get(name) ?? [])];
    madeSubmissions.value = new Map([...names].map((name) => [name, new Map(both(name))]));
  });
}

/** Remembers what was made: the result puts back what has been removed since. */
export function keepAllMade(): () => void {
  const [models, submissions] = [madeModels.value, madeSubmissions.value];
  return () => putBackMade(models, submissions);
}

/** Forgets what was made of and for one model. */
export function forget(name: string): void {
  batch(() => {
    madeModels.value = new Map([...madeModels.value].filter(([other]) => other !== name));
    madeSubmissions.value = new Map([...madeSubmissions.value].filter(([other]) => other !== name));
  });
}

export function forgetAll(): void {
  batch(() => {
    madeModels.value = new Map();
    madeSubmissions.value = new Map();
  });
}

/** Files were brought: what was only there to look at goes, with what was made of it. */
export function makeRoom(): void {
  const gone = new Set([...madeModels.value].flatMap(([name, { makesRoom }]) => (makesRoom ? [name] : [])));
  if (gone.size === 0) return;
  const without = <V>(all: ReadonlyMap<string, V>) => new Map([...all].filter(([name]) => !gone.has(name)));
  batch(() => {
    madeModels.value = without(madeModels.value);
    madeSubmissions.value = without(madeSubmissions.value);
  });
}

/** The names of what was made here to stay: what is brought takes none of them. */
export function madeNames(): string[] {
  return [...madeModels.value].flatMap(([name, { makesRoom }]) => (makesRoom ? [] : [name]));
}
