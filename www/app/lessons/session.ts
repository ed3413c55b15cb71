// A lesson's own engine: a worker that lives as long as the lesson is shown.

import type * as Comlink from "comlink";
import { effect } from "@preact/signals";
import { useLayoutEffect, useState } from "preact/hooks";
import script from "../../worker/lessons?worker&url";
import type { LessonsWorker } from "../../worker/lessons";
import { LiveWorker } from "../engine/live-worker";
import { startWorker } from "../engine/own-script";
import { notify } from "../state/notices";

export type LessonEngine = Comlink.Remote<LessonsWorker>;

/** The engine, and `run`, which tells of failures. */
export interface Session {
  readonly engine: LessonEngine;
  readonly run: (work: () => Promise<void>) => void;
}

/** How far the start of a lesson has come: neither session nor failure while it goes on. */
export interface Start {
  readonly session?: Session;
  /** Why there is no session. */
  readonly failure?: string;
  /** Starts anew, with a new engine. */
  readonly again: () => void;
}

const start = (name: string) => startWorker(script, name);

/** The session once `open` is done with it: before there is something to work on, no tool is shown that would do nothing. */
export function useSession(open: (session: Session) => Promise<void>): Start {
  const [outcome, setOutcome] = useState<Omit<Start, "again">>({});
  const [attempt, setAttempt] = useState(0);
  // Before the page is painted: `open` takes away what was found at an earlier visit.
  useLayoutEffect(() => {
    let stage: "starting" | "running" | "ended" = "starting";
    const end = () => {
      stage = "ended";
      worker.end();
    };
    const fail = (reason: string) => {
      if (stage === "ended") return;
      end();
      setOutcome({ failure: reason });
    };
    const tell = (reason: string) => {
      if (stage === "running") notify(reason, "error");
      else fail(reason);
    };
    const run = (work: () => Promise<void>) => {
      work().catch((error: unknown) => tell(error instanceof Error ? error.message : String(error)));
    };
    const worker = new LiveWorker<LessonsWorker>(start, { title: "The engine", onEnd: ({ message }) => fail(message) });
    const begun = { engine: worker.api, run };
    run(async () => {
      await open(begun);
      if (stage !== "starting") return;
      stage = "running";
      setOutcome({ session: begun });
    });
    return end;
  }, [attempt]);
  const again = () => {
    setOutcome({});
    setAttempt(attempt + 1);
  };
  return { ...outcome, again };
}

/**
 * Follows signals at once, where `useSignalEffect` waits for the next frame: what a step begins with must be set before
 * the reader can do anything in it, or it would undo what they did.
 */
export function useFollower(follow: () => void): void {
  useLayoutEffect(() => effect(follow), []);
}
