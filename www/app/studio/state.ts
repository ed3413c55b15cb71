// What the studio holds: the history of a case, and what the engine makes of its present state.

import * as Comlink from "comlink";
import { batch, computed, signal } from "@preact/signals";
import type { MadeCase, Stock, StudioWorker } from "../../worker/studio";
import { latest } from "../engine/latest";
import { FIRST, type Case } from "./case";
import { isCase, readCase } from "./link/link";
import { advance, begin, redo as redone, undo as undone, type History } from "./history";

const steps = signal<History<Case>>(begin(FIRST));

export const current = computed(() => steps.value.present.state);
/** What undo would take back, and redo bring back; nothing where there is nothing. */
export const undoable = computed(() => (steps.value.past.length > 0 ? steps.value.present.name : undefined));
export const redoable = computed(() => steps.value.future[0]?.name);

/** The case as it was made last: while it is being made or cannot be made, an earlier one. */
export const made = signal<{ readonly of: Case; readonly result: MadeCase } | undefined>(undefined);
export const making = signal(false);
/** Why the present case cannot be made. */
export const failure = signal<string | undefined>(undefined);
/** Why the link in the address could not be opened. */
export const damaged = signal<string | undefined>(undefined);
export const stock = signal<Stock>({ shapes: [], parts: [] });

interface Session {
  readonly worker: Worker;
  readonly engine: Comlink.Remote<StudioWorker>;
  readonly make: (of: Case) => Promise<void>;
}

let session: Session | undefined;

/** Begins the studio's work; it goes on until `close`. */
export function open(): void {
  readAddress();
  remake();
}

export function close(): void {
  session?.worker.terminate();
  session = undefined;
  batch(() => {
    made.value = undefined;
    making.value = false;
  });
}

/** Gives up making the present case, which takes too long. */
export function stop(): void {
  session?.worker.terminate();
  session = start();
  batch(() => {
    making.value = false;
    failure.value = "It was stopped. Undo the last step, or change something to try again.";
  });
}

/** What is asked of the engine about the case made last. */
export async function ask<T>(question: (engine: Comlink.Remote<StudioWorker>) => Promise<T>): Promise<T> {
  if (!session) throw new Error("The studio is closed.");
  return question(session.engine);
}

function start(): Session {
  const worker = new Worker(new URL("../../worker/studio.ts", import.meta.url), { type: "module", name: "studio" });
  const engine = Comlink.wrap<StudioWorker>(worker);
  const own: Session = {
    worker,
    engine,
    make: latest(async (of: Case) => {
      const outcome = await engine.make(of).then(
        (result) => ({ result }),
        (error: unknown) => ({ error: error instanceof Error ? error.message : String(error) }),
      );
      if (session !== own) return;
      batch(() => {
        const last = of === current.value;
        if (last) making.value = false;
        if ("result" in outcome) made.value = { of, result: outcome.result };
        if (last) failure.value = "error" in outcome ? outcome.error : undefined;
      });
    }),
  };
  worker.addEventListener("error", (event) => tell(new Error(event.message || "The engine could not be started.")));
  // Asked before the case: one that takes long, and is stopped, must not leave the forms empty.
  if (stock.peek().shapes.length === 0) void engine.stock().then((found) => (stock.value = found), tell);
  return own;
}

function tell(error: unknown): void {
  batch(() => {
    making.value = false;
    failure.value = error instanceof Error ? error.message : String(error);
  });
}

function remake(): void {
  session ??= start();
  making.value = true;
  void session.make(current.value);
}

/** Changes the case; `name` says what was done, in a few words. Steps with the same `merge` in succession are one. */
export function edit(change: Partial<Case>, name: string, merge?: string): void {
  const next = { state: { ...current.value, ...change }, name, ...(merge === undefined ? {} : { merge }) };
  show(advance(steps.value, next));
}

export function undo(): void {
  show(undone(steps.value));
}

export function redo(): void {
  show(redone(steps.value));
}

function show(next: History<Case>): void {
  const before = current.value;
  steps.value = next;
  if (current.value === before) return;
  forgetAddress();
  remake();
}

/** Opens the case in the address, if there is one, as a step like others. */
export function readAddress(): void {
  if (!isCase(location.hash)) return;
  try {
    const found = readCase(location.hash);
    damaged.value = undefined;
    if (JSON.stringify(found) === JSON.stringify(current.value)) return;
    steps.value = steps.value.past.length > 0 ? advance(steps.value, { state: found, name: "Open the link" }) : begin(found);
    if (session) remake();
  } catch (error) {
    damaged.value = error instanceof Error ? error.message : String(error);
  }
}

/** An address must not go on naming a case that has changed since. */
function forgetAddress(): void {
  if (isCase(location.hash)) history.replaceState(history.state, "", `${location.pathname}${location.search}`);
}
