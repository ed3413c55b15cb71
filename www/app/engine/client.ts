// The page's one way to the engine.

import type { EngineWorker } from "../../worker/protocol";
import { WorkerPool } from "./pool";

/** One core is left to the page itself; more than eight workers only cost memory. */
const WORKERS = Math.min(8, Math.max(1, (navigator.hardwareConcurrency || 2) - 1));

export const engine = new WorkerPool<EngineWorker>(
  () => new Worker(new URL("../../worker/engine.ts", import.meta.url), { type: "module", name: "engine" }),
  WORKERS,
);
