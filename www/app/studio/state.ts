// What the studio holds: the history of a case, and what the engine makes of its present state.

import type * as Comlink from "comlink";
import { batch, computed, signal } from "@preact/signals";
import script from "../../worker/studio?worker&url";
import type { MadeCase, StudioWorker, Weight } from "../../worker/studio";
import { latest } from "../engine/latest";
import { LiveWorker } from "../engine/live-worker";
import { startWorker } from "../engine/own-script";
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
/** Version of the engine, once it is there. */
export const engineHere = signal<string | undefined>(undefined);

/** Version of the engine that the link of the present case was made with, where it says. */
export const linkedWith = signal<string | undefined>(undefined);

/**
 * The case of a link that takes long to make, and what it takes: it waits to be asked for. Where finding that out
 * takes long itself, there is no weight.
 */
export const offered = signal<{ readonly of: Case; readonly weight: Weight | undefined } | undefined>(undefined);

/** A link may have made unasked what takes no longer, in seconds; nor may it take longer to find that out. */
const UNASKED_SECONDS = 3;

/** The case of a link that nobody has looked into yet: whoever made it chose what it takes. */
let unweighed: Case | undefined;


interface Session {
  readonly worker: LiveWorker<StudioWorker>;
  readonly make: (of: Case) => Promise<void>;
}

let session: Session | undefined;

/** Begins the studio's work; it goes on until `close`. */
export function open(): void {
  readAddress();
  if (offered.peek()?.of === current.peek()) session ??= start();
  else remake();
}

export function close(): void {
  session?.worker.end();
  session = undefined;
  batch(() => {
    made.value = undefined;
    making.value = false;
  });
}

/** Gives up making the present case, which takes too long. */
export function stop(): void {
  session?.worker.end();
  session = start();
  batch(() => {
    making.value = false;
    failure.value = "It was stopped. Undo the last step, or change something to try again.";
  });
}

/** What is asked of the engine about the case made last. */
export async function ask<T>(question: (engine: Comlink.Remote<StudioWorker>) => Promise<T>): Promise<T> {
  if (!session) throw new Error("The studio is closed.");
  return question(session.worker.api);
}

function start(): Session {
  const onEnd = (reason: Error) => {
    // The next change starts another.
    if (session === own) session = undefined;
    tell(reason);
  };
  const worker = new LiveWorker<StudioWorker>((name) => startWorker(script, name), { title: "The engine", onEnd });
  const own: Session = {
    worker,
    make: latest(async (of: Case) => {
      if (of === unweighed && !(await isQuick(worker.api, of))) return;
      const outcome = await worker.api.make(of).then(
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
  // Asked before the case, which may take long.
  if (engineHere.peek() === undefined) void worker.api.version().then((found) => (engineHere.value = found), tell);
  return own;
}

/** Whether a link's case is quickly made; otherwise it is offered. */
async function isQuick(engine: Comlink.Remote<StudioWorker>, of: Case): Promise<boolean> {
  // Loading the engine does not count.
  await engine.version().catch(tell);
  // What cannot be weighed cannot be made, and making it says why.
  const weighed = engine.weigh(of).catch(() => "impossible" as const);
  const weight = await Promise.race([weighed, pause(1000 * UNASKED_SECONDS)]);
  if (of !== unweighed) return false;
  unweighed = undefined;
  if (weight === "impossible" || (weight && weight.seconds <= UNASKED_SECONDS)) return true;
  if (!weight) {
    session?.worker.end();
    session = start();
  }
  batch(() => {
    offered.value = { of, weight };
    making.value = false;
  });
  return false;
}

function pause(milliseconds: number): Promise<undefined> {
  return new Promise((resolve) => setTimeout(resolve, milliseconds, undefined));
}

/** Makes the case of a link that takes long, as the reader asked. */
export function makeOffered(): void {
  remake();
}

function tell(error: unknown): void {
  batch(() => {
    making.value = false;
    failure.value = error instanceof Error ? error.message : String(error);
  });
}

function remake(): void {
  session ??= start();
  offered.value = undefined;
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
  // From here on it is the reader's own.
  unweighed = undefined;
  linkedWith.value = undefined;
  forgetAddress();
  remake();
}

/** Opens the case in the address, if there is one, as a step like others. */
export function readAddress(): void {
  if (!isCase(location.hash)) return;
  try {
    const { of: found, engine } = readCase(location.hash);
    damaged.value = undefined;
    linkedWith.value = engine;
    if (JSON.stringify(found) === JSON.stringify(current.value)) return;
    unweighed = found;
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
