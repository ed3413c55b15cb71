// A lesson's own engine: a worker that lives as long as the lesson is shown.

import * as Comlink from "comlink";
import { effect } from "@preact/signals";
import { useEffect, useLayoutEffect, useState } from "preact/hooks";
import type { LessonsWorker } from "../../worker/lessons";
import { notify } from "../state/notices";

export type LessonEngine = Comlink.Remote<LessonsWorker>;

/** The engine, and `run`, which tells of failures. */
export interface Session {
  readonly engine: LessonEngine;
  readonly run: (work: () => Promise<void>) => void;
}

/** The session once `open` is done with it: before there is something to work on, no tool is shown that would do nothing. */
export function useSession(open: (session: Session) => Promise<void> = () => Promise.resolve()): Session | undefined {
  const [session, setSession] = useState<Session>();
  useEffect(() => {
    const worker = new Worker(new URL("../../worker/lessons.ts", import.meta.url), { type: "module", name: "lesson" });
    let ended = false;
    const engine = Comlink.wrap<LessonsWorker>(worker);
    const run = (work: () => Promise<void>) => {
      work().catch((error: unknown) => {
        if (!ended) notify(error instanceof Error ? error.message : String(error), "error");
      });
    };
    const begun = { engine, run };
    run(async () => {
      await open(begun);
      if (!ended) setSession(begun);
    });
    return () => {
      ended = true;
      worker.terminate();
    };
  }, []);
  return session;
}

/**
 * Follows signals at once, where `useSignalEffect` waits for the next frame: what a step begins with must be set before
 * the reader can do anything in it, or it would undo what they did.
 */
export function useFollower(follow: () => void): void {
  useLayoutEffect(() => effect(follow), []);
}
