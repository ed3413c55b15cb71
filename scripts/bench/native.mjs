// The engine natively, as the Python package has it: threads side by side, and Dask against a plain loop.

import { join } from "node:path";
import { buildWheel, pythonOf } from "../lib/python.mjs";
import { ROOT, benchmarkFiles } from "../lib/paths.mjs";
import { run } from "../lib/run.mjs";
import { Skipped } from "../lib/steps.mjs";

export const name = "native";
export const about = "the Python package: fits on threads, Dask against a plain loop";

/** What Dask may cost over a loop that does the same, in per cent of processor time. */
const MOST_OVERHEAD = 10;

/** @typedef {{ seconds: number, processor: number }} Spent wall clock and processor, the latter of all threads together */
/**
 * What `native.py` prints.
 * @typedef {object} Measured
 * @property {({ method: string, jobs: number, models: number, same: boolean } & Spent)[]} fits
 * @property {{ models: number, workers: number, loop: Spent, idle: Spent, cluster: Spent }} overhead
 */

/**
 * @param {import("../lib/bench.mjs").Bench} bench
 * @param {import("../bench.mjs").Options} options
 */
export async function measure(bench, { quick }) {
  try {
    await buildWheel("wheel");
  } catch (error) {
    if (!(error instanceof Skipped)) throw error;
    bench.note(error.message);
    return;
  }
  const shared = benchmarkFiles();
  if (shared === undefined) bench.note("the public files are not at hand; generated parts instead");
  const paths = shared === undefined || quick ? [] : [join(shared, "training_set.zip")];
  const script = join(ROOT, "scripts/bench/native.py");
  const said = await run(pythonOf(), [script, quick ? "100" : "1000", ...paths], { capture: true });
  const { fits, overhead } = /** @type {Measured} */ (JSON.parse(said.trim().split("\n").at(-1) ?? ""));
  bench.table({
    title: "Clouds fitted side by side",
    note: `${fits[0]?.models ?? 0} models; the answers are the same${fits.every(({ same }) => same) ? "" : " NOT"}`,
    head: ["method", "threads", "models/s", "models/s of processor"],
    rows: fits.map(({ method, jobs, models, seconds, processor }) => [method.toUpperCase(), String(jobs), (models / seconds).toFixed(1), (models / processor).toFixed(1)]),
  });
  const { models, workers, loop, idle, cluster } = overhead;
  // Its heartbeats go by the clock: those of the time for which it waited for a core are no cost of the work. On a
  // machine with nothing else to do there is no such time.
  const waited = Math.max(0, cluster.seconds - cluster.processor / workers);
  const spent = cluster.processor - (waited * idle.processor) / idle.seconds;
  bench.note(`${models} generated models of about 3,000 points made and scored by ${workers} workers of Dask`);
  bench.figure("models per second of processor, a plain loop", models / loop.processor, "/s", { digits: 1 });
  bench.figure("models per second of processor, Dask with all it does", models / spent, "/s", { digits: 1 });
  bench.figure("models per second of the clock, Dask on all workers", models / cluster.seconds, "/s", { digits: 1 });
  bench.figure("overhead of Dask, processor", 100 * (spent / loop.processor - 1), "%", { most: MOST_OVERHEAD, digits: 1 });
}
