// Looking at the selected primitive alone, and putting primitives out of sight or out of the cursor's reach.

import { batch, computed, signal } from "@preact/signals";
import { selectedPrimitive, type PrimitiveRef } from "../state/selection";
import { remembered } from "../state/settings";
import { partnersOf } from "./colouring";
import { currentView } from "./current";
import { frame } from "./framing";
import { reports } from "./reports";
import { where } from "./where";

/** Whether everything but the selected primitive and its partner is out of sight. */
export const isolated = signal(false);

/** What is out of sight: not drawn, or drawn almost in the colour of the background. */
export const asideLooks = remembered("hidden", "gone", ["gone", "faint"] as const);

/** Primitives by their names; each stands for its partners as well. */
type Refs = ReadonlyMap<string, PrimitiveRef>;

interface Aside {
  readonly where: string;
  readonly hidden: Refs;
  readonly locked: Refs;
  /** Whether the points of no primitive are out of sight too. */
  readonly rest: boolean;
}

const NOTHING: Aside = { where: "", hidden: new Map(), locked: new Map(), rest: false };

const kept = signal(NOTHING);
const aside = computed(() => (kept.value.where === where.value ? kept.value : NOTHING));

/** Primitives put out of sight. */
export const hidden = computed(() => aside.value.hidden);
/** Primitives that a click in the picture does not find. */
export const locked = computed(() => aside.value.locked);
/** Whether the points of no primitive are put out of sight. */
export const restHidden = computed(() => aside.value.rest);
/** How many things are out of sight. */
export const hiddenCount = computed(() => hidden.value.size + Number(restHidden.value));

/** The primitive that stands for another and its partners: the true one where there is one. */
export function standsFor(ref: PrimitiveRef): PrimitiveRef {
  const { truth } = partnersOf(reports.value, ref);
  return truth === undefined ? ref : { side: "truth", index: truth };
}

export function nameOfRef({ side, index }: PrimitiveRef): string {
  return `${side} ${index}`;
}

export function isLocked(ref: PrimitiveRef): boolean {
  return locked.value.size > 0 && locked.value.has(nameOfRef(standsFor(ref)));
}

function put(change: Partial<Aside>): void {
  kept.value = { ...aside.value, ...change, where: where.value };
}

function changed(refs: Refs, which: readonly PrimitiveRef[], to: boolean): Refs {
  const all = new Map(refs);
  for (const each of which) {
    const ref = standsFor(each);
    if (to) all.set(nameOfRef(ref), ref);
    else all.delete(nameOfRef(ref));
  }
  return all;
}

export function setHidden(refs: readonly PrimitiveRef[], to: boolean): void {
  put({ hidden: changed(hidden.value, refs, to) });
}

export function setLocked(refs: readonly PrimitiveRef[], to: boolean): void {
  put({ locked: changed(locked.value, refs, to) });
}

export function setRestHidden(to: boolean): void {
  put({ rest: to });
}

/** Puts all others out of sight, and the points of no primitive. */
export function showOnly(refs: readonly PrimitiveRef[], all: readonly PrimitiveRef[]): void {
  put({ hidden: changed(changed(new Map(), all, true), refs, false), rest: true });
}

export function toggleIsolated(): void {
  if (selectedPrimitive.value) isolated.value = !isolated.value;
}

export function hideSelected(): void {
  const ref = selectedPrimitive.value;
  if (!ref) return;
  batch(() => {
    setHidden([ref], true);
    selectedPrimitive.value = undefined;
  });
}

export function lockSelected(): void {
  const ref = selectedPrimitive.value;
  if (ref) setLocked([ref], !isLocked(ref));
}

export function showAll(): void {
  put({ hidden: new Map(), rest: false });
  isolated.value = false;
}

export function unlockAll(): void {
  put({ locked: new Map() });
}

/** Takes back what is out of sight, then what is locked; whether there was anything to take back. */
export function takeAsideBack(): boolean {
  if (hiddenCount.value > 0) showAll();
  else if (locked.value.size > 0) unlockAll();
  else return false;
  return true;
}

export function frameSelected(): void {
  const ref = selectedPrimitive.value;
  const view = currentView.value;
  if (view && !(ref && frame(view, ref))) view.fit();
}
