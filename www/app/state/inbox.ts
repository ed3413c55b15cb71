// Every file the reader has brought, and how the engine sorted the heap into models.
//
// The whole heap is sorted anew whenever something is added or corrected, so a submission dropped
// today finds the ground truth dropped before it. Only models whose files changed are scored again.

import { batch, computed, signal } from "@preact/signals";
import { engine } from "../engine/client";
import type { Grouping, Override } from "../engine/contract";
import type { PublicModel } from "../public/catalogue";
import type { FitRequest, ModelFile } from "../../worker/protocol";
import { sourceOf } from "./content";
import { models, type ModelEntry, type Origin } from "./models";
import { scoreAll } from "./scoring";
import { notify } from "./notices";
import { selectModel, selectedModel } from "./selection";

/** A file as it was brought: its path within what was dropped or chosen, and its content. */
export interface BroughtFile {
  readonly path: string;
  readonly data: Blob;
  /** The public model it was downloaded for. */
  readonly publicModel?: PublicModel;
}

export interface Unplaced {
  readonly path: string;
  readonly reason: string;
}

export const brought = signal<ReadonlyMap<string, BroughtFile>>(new Map());
export const overrides = signal<Readonly<Record<string, Override>>>({});
/** Files that could not be had (not opened, not downloaded), by path with the last reason. */
const refused = signal<ReadonlyMap<string, string>>(new Map());
/** Files that were had and belong to no model. */
const homeless = signal<readonly Unplaced[]>([]);
/** Every file that is part of no model, with the reason. */
export const unplaced = computed<readonly Unplaced[]>(() => [
  ...Array.from(refused.value, ([path, reason]) => ({ path, reason })),
  ...homeless.value,
]);
/** How many files were litter (`.DS_Store` and the like). */
export const ignored = signal(0);

interface Made {
  readonly origin: Origin;
  readonly files: readonly ModelFile[];
  /** How submissions were fitted, by their names. */
  readonly fits: Readonly<Record<string, FitRequest>>;
  /** Whether it was only there to look at, and goes when the first files are brought. */
  readonly makesRoom: boolean;
}

/** Models that were made here, not brought as files, and submissions made here for any model. */
const made = signal<ReadonlyMap<string, Made>>(new Map());

/** Takes files in and scores what they make. `lacking` are files that could not even be opened. */
export async function receive(files: readonly BroughtFile[], lacking: readonly Unplaced[] = []): Promise<void> {
  refused.value = new Map([
    ...[...refused.value].filter(([path]) => !files.some((file) => holds(path, file.path))),
    ...lacking.map(({ path, reason }) => [path, reason] as const),
  ]);
  const heap = new Map(brought.value);
  for (const file of files) heap.set(file.path, file);
  brought.value = heap;
  const before = new Set(models.value.map((entry) => entry.source.key));
  await regroup();
  const fresh = models.value.filter((entry) => !before.has(entry.source.key));
  const first = fresh[0];
  if (first) selectModel(first.id);
  const count = (n: number, what: string) => `${n} ${what}${n === 1 ? "" : "s"}`;
  notify(
    `${count(files.length, "file")} received: ${count(fresh.length, "model")} new or changed` +
      (unplaced.value.length > 0 ? `, ${count(unplaced.value.length, "file")} not placed (see Diagnostics).` : "."),
  );
}

/** Whether a path is that of a file or of the zip it was in. */
function holds(path: string, file: string): boolean {
  return file === path || file.startsWith(`${path}/`);
}

/** Corrects how one file is understood; an empty override takes the correction back. */
export async function override(path: string, change: Override): Promise<void> {
  const { [path]: _, ...others } = overrides.value;
  overrides.value = Object.keys(change).length > 0 ? { ...others, [path]: change } : others;
  await regroup();
}

/** How a model comes on the page: into view, aside of what is in view, or until something is brought. */
export type Entrance = "shown" | "quiet" | "opening";

/** Puts a model on the page that was made here, beside what is there: where its name is taken, it gets a number. The result is its name. */
export function addMade(wanted: string, origin: Origin, files: readonly ModelFile[], how: Entrance): string | undefined {
  // It makes room for what was brought while it was being made, too.
  if (how === "opening" && models.value.length > 0) return undefined;
  const name = freeName(wanted, models.value.map(({ id }) => id));
  made.value = new Map(made.value).set(name, { origin, files, fits: {}, makesRoom: how === "opening" });
  assemble(lastGrouping);
  if (how !== "quiet") selectModel(name);
  return name;
}

/** Asks for a model made here that is on the page already: it stays, whatever is brought. */
export function keepMade(name: string, how: Entrance): void {
  const known = made.value.get(name);
  if (!known || how === "opening") return;
  made.value = new Map(made.value).set(name, { ...known, makesRoom: false });
  if (how === "shown") selectModel(name);
}

function freeName(wanted: string, taken: readonly string[]): string {
  if (!taken.includes(wanted)) return wanted;
  let number = 2;
  while (taken.includes(`${wanted}-${number}`)) number += 1;
  return `${wanted}-${number}`;
}

/** Adds a submission made here (by a fitter) to a model that is on the page. */
export function addSubmission(name: string, method: string, files: readonly ModelFile[], request: FitRequest): void {
  const entry = models.value.find(({ id }) => id === name);
  if (!entry) return;
  const known = made.value.get(name) ?? { origin: entry.origin, files: [], fits: {}, makesRoom: false };
  const kept = known.files.filter((file) => !files.some(({ path }) => path === file.path));
  const fits = { ...known.fits, [method]: request };
  made.value = new Map(made.value).set(name, { ...known, files: [...kept, ...files], fits });
  assemble(lastGrouping);
}

/** Whether a submission was made here, not brought. */
export function isMadeHere(name: string, method: string): boolean {
  return made.value.get(name)?.files.some((file) => file.method === method) ?? false;
}

/** How a submission was fitted here; nothing for one that was brought. */
export function fitOf(name: string, method: string): FitRequest | undefined {
  return isMadeHere(name, method) ? made.value.get(name)?.fits[method] : undefined;
}

/** Takes a submission made here off its model. */
export function removeSubmission(name: string, method: string): void {
  const known = made.value.get(name);
  if (!known) return;
  const files = known.files.filter((file) => file.method !== method);
  made.value = new Map(made.value).set(name, { ...known, files });
  assemble(lastGrouping);
}

/** Takes a model off the page, with its files. */
export function remove(id: string): void {
  const entry = models.value.find((candidate) => candidate.id === id);
  if (!entry) return;
  const paths = new Set(entry.source.files.map(({ path }) => path));
  brought.value = new Map([...brought.value].filter(([path]) => !paths.has(path)));
  made.value = new Map([...made.value].filter(([name]) => name !== id));
  lastGrouping = { ...lastGrouping, models: lastGrouping.models.filter(({ name }) => name !== id) };
  assemble(lastGrouping);
}

/** Takes everything off the page. */
export function clear(): void {
  batch(() => {
    brought.value = new Map();
    overrides.value = {};
    refused.value = new Map();
    made.value = new Map();
    lastGrouping = NOTHING;
    assemble(NOTHING);
  });
}

const NOTHING: Grouping = { models: [], unplaced: [], ignored: 0 };
let lastGrouping: Grouping = NOTHING;

/** One at a time: a heap sorted later must not be overtaken by an earlier one. */
let sorting: Promise<void> = Promise.resolve();

function regroup(): Promise<void> {
  sorting = sorting.catch(() => undefined).then(sortAnew);
  return sorting;
}

async function sortAnew(): Promise<void> {
  const paths = [...brought.value.keys()];
  lastGrouping = await engine.run((api) => api.group(paths, overrides.value));
  const names = lastGrouping.models.map(({ name }) => name);
  if (names.length > 0) {
    made.value = renamed(new Map([...made.value].filter(([, { makesRoom }]) => !makesRoom)), names);
  }
  assemble(lastGrouping);
}

/** Models made here that have the name of brought ones get others. What was only fitted here goes with the model it is for. */
function renamed(all: ReadonlyMap<string, Made>, brought: readonly string[]): ReadonlyMap<string, Made> {
  const taken = [...brought, ...all.keys()];
  const isModel = ({ files }: Made) => files.some(({ method }) => method === undefined);
  return new Map(
    Array.from(all, ([name, own]) => {
      if (!isModel(own) || !brought.includes(name)) return [name, own];
      const free = freeName(name, taken);
      taken.push(free);
      return [free, own];
    }),
  );
}

function assemble(grouping: Grouping): void {
  const entries: ModelEntry[] = [];
  for (const { name, number, files } of grouping.models) {
    const extra = made.value.get(name)?.files ?? [];
    entries.push(entryOf(name, number, originOf(files), [...withContent(files), ...extra]));
  }
  for (const [name, { origin, files }] of [...made.value].sort(([a], [b]) => a.localeCompare(b, "en", { numeric: true }))) {
    if (!entries.some(({ id }) => id === name)) entries.push(entryOf(name, undefined, origin, files));
  }
  batch(() => {
    models.value = entries;
    homeless.value = grouping.unplaced;
    ignored.value = grouping.ignored;
    if (!entries.some(({ id }) => id === selectedModel.value)) selectModel(entries[0]?.id);
  });
  scoreAll(entries.filter(({ status }) => status.kind === "waiting"));
}

/** A model whose cloud and truth are those of one public model, as downloaded and not corrected, is that model. */
function originOf(files: Grouping["models"][number]["files"]): Origin {
  const own = files.filter(({ method }) => method === undefined);
  const [first] = own.map(({ path }) => brought.value.get(path)?.publicModel);
  const same = own.every(({ path }) => {
    const { publicModel } = brought.value.get(path) ?? {};
    return publicModel?.set === first?.set && publicModel?.number === first?.number && overrides.value[path] === undefined;
  });
  return first && same ? { kind: "public", model: first } : { kind: "files" };
}

function withContent(files: Grouping["models"][number]["files"]): ModelFile[] {
  return files.flatMap((file) => {
    const data = brought.value.get(file.path)?.data;
    return data ? [{ ...file, data }] : [];
  });
}

function entryOf(id: string, number: number | undefined, origin: Origin, files: readonly ModelFile[]): ModelEntry {
  const source = sourceOf(id, files);
  const known = models.value.find((entry) => entry.source.key === source.key);
  return { id, number, origin, source, status: known?.status ?? { kind: "waiting" } };
}
