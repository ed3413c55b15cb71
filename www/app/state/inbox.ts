// Every file the reader has brought, and how the engine sorts the heap into models.
//
// The whole heap is sorted anew whenever something is added or corrected, so a submission dropped
// today finds the ground truth dropped before it.

import { batch, computed, effect, signal, untracked } from "@preact/signals";
import { engine } from "../engine/client";
import type { Grouping, Override, Recognised } from "../engine/contract";
import { latest } from "../engine/latest";
import { named, namesOf, type Names } from "./identity";
import { madeNames, makeRoom } from "./made";
import { notify } from "./notices";
import type { EngineWorker } from "../../worker/protocol";
import type { PublicModel, StepSource } from "./origin";

/** A file as it was brought: its path within what was dropped or chosen, and its content. */
export interface BroughtFile {
  readonly path: string;
  readonly data: Blob;
  /** The public model it was downloaded for. */
  readonly publicModel?: PublicModel;
  /** The STEP file it was made of: of clouds alone. */
  readonly step?: StepSource;
  /** Where the page's own address had it fetched (`?data=`, `?source=`): whoever made that address chose it, not the reader. */
  readonly named?: string;
}

export interface Unplaced {
  readonly path: string;
  readonly reason: string;
  /** What the engine took it for; absent where that is not told, and for what was not even opened. */
  readonly recognised?: Recognised | undefined;
}

type Heap = ReadonlyMap<string, BroughtFile>;
type Overrides = Readonly<Record<string, Override>>;

export const brought = signal<Heap>(new Map());
export const overrides = signal<Overrides>({});
/** Files that could not be had (not opened, not downloaded), by path with the last reason. */
const refused = signal<ReadonlyMap<string, string>>(new Map());

const NOTHING: Grouping = { models: [], unplaced: [], ignored: 0 };

/** How the heap was sorted last, under the names of the page. Of a heap that has changed since it may name files that are gone. */
export const grouping = signal<Grouping>(NOTHING);

/** The models that files were of when the heap was sorted last; of files that were taken off it, their last. */
export const names = signal<Names>(new Map());

/** What the engine calls the models of the heap, by their names on the page. */
let engineNames: Names = new Map();

/** What the engine calls a model, without the folders it is in. */
export function bareName(model: string): string {
  const name = engineNames.get(model) ?? model;
  return name.slice(name.lastIndexOf("/") + 1);
}

/** Every file that is part of no model, with the reason. */
export const unplaced = computed<readonly Unplaced[]>(() => [
  ...Array.from(refused.value, ([path, reason]) => ({ path, reason })),
  ...grouping.value.unplaced.filter(({ path }) => brought.value.has(path)),
]);

/** How many files were litter (`.DS_Store` and the like). */
export const ignored = computed(() => grouping.value.ignored);

/** Lays files on the heap; resolves when it is sorted. `lacking` are files that could not even be opened. */
export function bring(files: readonly BroughtFile[], lacking: readonly Unplaced[]): Promise<void> {
  const had = new Set(files.flatMap(({ path }) => waysTo(path)));
  batch(() => {
    refused.value = new Map([
      ...[...refused.value].filter(([path]) => !had.has(path)),
      ...lacking.map(({ path, reason }) => [path, reason] as const),
    ]);
    brought.value = new Map([...brought.value, ...files.map((file) => [file.path, file] as const)]);
  });
  return sorted;
}

/** The path of a file, and of every zip and folder it was in. */
function waysTo(path: string): string[] {
  const ways = [path];
  for (let end = path.lastIndexOf("/"); end > 0; end = path.lastIndexOf("/", end - 1)) ways.push(path.slice(0, end));
  return ways;
}

/** Takes files off the heap. */
export function discard(paths: ReadonlySet<string>): void {
  brought.value = new Map([...brought.value].filter(([path]) => !paths.has(path)));
}

/** Remembers the heap: the result puts back what has been taken off it since. */
export function keepBrought(): () => void {
  const before = { heap: brought.value, corrected: overrides.value, lacking: refused.value, called: names.value };
  return () =>
    batch(() => {
      names.value = new Map([...before.called, ...names.value]);
      brought.value = new Map([...before.heap, ...brought.value]);
      overrides.value = { ...before.corrected, ...overrides.value };
      refused.value = new Map([...before.lacking, ...refused.value]);
    });
}

/** Takes everything off the heap, with what was said of it. */
export function discardAll(): void {
  batch(() => {
    brought.value = new Map();
    overrides.value = {};
    refused.value = new Map();
    names.value = new Map();
  });
}

/** Corrects how one file is understood; an empty override takes the correction back. */
export function override(path: string, change: Override): void {
  const { [path]: _, ...others } = overrides.value;
  overrides.value = Object.keys(change).length > 0 ? { ...others, [path]: change } : others;
}

/** One at a time: a heap sorted later must not be overtaken by an earlier one. */
const sort = latest(async ({ heap, corrected }: { heap: Heap; corrected: Overrides }) => {
  const paths = [...heap.keys()];
  const found = paths.length > 0 ? await engine.run((api) => groupAll(api, paths, corrected)) : NOTHING;
  batch(() => {
    if (found.models.length > 0) makeRoom();
    const said = Object.entries(corrected).flatMap(([path, { model }]) => (model === undefined ? [] : [[path, model] as const]));
    const models = named(found.models, new Map([...names.value, ...said]), madeNames());
    engineNames = new Map(models.map(({ name }, at) => [name, found.models[at]?.name ?? name]));
    grouping.value = { ...found, models };
    // What a file was before it was corrected is what it is once the correction is taken back.
    names.value = new Map([...names.value, ...[...namesOf(models)].filter(([path]) => corrected[path]?.model === undefined)]);
  });
});

/** Sorts the heap. Corrections name models as the page does, which the engine may call otherwise. */
async function groupAll(api: Pick<EngineWorker, "group">, paths: string[], corrected: Overrides): Promise<Grouping> {
  if (Object.values(corrected).every(({ model }) => model === undefined)) return api.group(paths, corrected);
  const each = (change: (one: Override) => Override) => Object.fromEntries(Object.entries(corrected).map(([path, one]) => [path, change(one)]));
  const { models } = await api.group(paths, each(({ model: _, ...rest }) => rest));
  const called = new Map(named(models, names.value, madeNames()).map(({ name }, at) => [name, models[at]?.name ?? name]));
  return api.group(paths, each((one) => (one.model === undefined ? one : { ...one, model: called.get(one.model) ?? one.model })));
}

let sorted: Promise<void> = Promise.resolve();

/** Sorts the heap, and again whenever it changes, until the result is called. */
export function sortBrought(): () => void {
  return effect(() => {
    const request = { heap: brought.value, corrected: overrides.value };
    sorted = untracked(() => sort(request));
    sorted.catch((error: unknown) => notify(error instanceof Error ? error.message : String(error), "error"));
  });
}
