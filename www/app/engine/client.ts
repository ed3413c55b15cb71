// The page's one way to the engine.

import script from "../../worker/engine?worker&url";
import type { EngineWorker } from "../../worker/protocol";
import { LiveWorker } from "./live-worker";
import { startWorker } from "./own-script";
import { WorkerPool } from "./pool";

/** One core is left to the page itself; more than eight workers only cost memory. */
export const WORKERS = Math.min(8, Math.max(1, (navigator.hardwareConcurrency || 2) - 1));

const start = (name: string) => startWorker(script, name);

export const engine = new WorkerPool<EngineWorker>(
  (onEnd) => new LiveWorker(start, { title: "The engine", onEnd }),
  WORKERS,
);
