// `--jobs`: the models of a call shared out among threads, each with an engine of its own. What becomes of a
// model hangs on nothing but its files, and answers are put back into the order of the models.

import { availableParallelism } from "node:os";
import { Worker } from "node:worker_threads";
import { number } from "./usage.mjs";

/** @typedef {import("./inputs.mjs").Diagnostic} Diagnostic */

export const JOBS_OPTIONS = /** @type {const} */ ({ jobs: { type: "string" } });

/** What `--help` says of it. */
export const JOBS_HELP = "works on N models at once, 0 for as many as there are cores; the answers are the same";

/** More threads than any machine has use for: each takes an engine's memory. */
const MOST = 256;

/** @param {{ jobs?: string | undefined }} values */
export function jobsOf({ jobs }) {
  const given = number("jobs", jobs, { least: 0, most: MOST, whole: true });
  return given === 0 ? Math.min(availableParallelism(), MOST) : (given ?? 1);
}

/**
 * What a thread is asked for.
 * @typedef {{ task: "score", request: import("./evaluate.mjs").Asked }
 *   | { task: "fit", request: import("./fitting.mjs").Settings & { out: string | undefined } }} Order
 */

/** @typedef {{ paths: readonly string[], files: number, claims: Int32Array, order: Order }} WorkerData */
/** @typedef {{ listed: true } | { place: string } | { answer: unknown }} Told */

/**
 * Has an order carried out by so many threads; gives the answer of each. Every thread lists the files for
 * itself, and none begins before all have: what a fit writes is not taken for an input.
 * @param {Order} order
 * @param {{ jobs: number, paths: readonly string[], files: number, progress: (text: string) => void }} how
 * @returns {Promise<unknown[]>}
 */
export async function shareOut(order, { jobs, paths, files, progress }) {
  // A model has at least one file.
  const claims = new Int32Array(new SharedArrayBuffer(4 * Math.max(files, 1)));
  /** @type {WorkerData} */
  const workerData = { paths, files, claims, order };
  const workers = Array.from({ length: Math.min(jobs, Math.max(files, 1)) }, () => new Worker(new URL("./worker.mjs", import.meta.url), { workerData }));
  let listed = 0;
  const answers = workers.map(
    (worker) =>
      new Promise((done, fail) => {
        worker.on("message", (/** @type {Told} */ told) => {
          if ("answer" in told) {
            done(told.answer);
          } else if ("place" in told) {
            progress(told.place);
          } else {
            listed += 1;
            if (listed === workers.length) for (const each of workers) each.postMessage("begin");
          }
        });
        worker.on("error", fail);
        worker.on("exit", (code) => fail(new Error(`a thread ended with code ${code} before it was done`)));
      }),
  );
  try {
    return await Promise.all(answers);
  } finally {
    await Promise.all(workers.map((worker) => worker.terminate()));
  }
}
