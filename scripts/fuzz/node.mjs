// Runs a target of JavaScript on mutated inputs: `node scripts/fuzz/node.mjs TARGET [--runs N] [--seconds N] [--seed N]
// [--replay FILE]`. Blind, without coverage. The work is done in a worker, which is watched from here: what takes more
// than two seconds of processor time, or much more memory than its input is long, is a fault as an error is.

import { createHash } from "node:crypto";
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { parseArgs } from "node:util";
import { Worker, isMainThread, parentPort, workerData } from "node:worker_threads";
import { ROOT } from "../lib/paths.mjs";
import { generator } from "../../tests/node/random.mjs";
import { mutate } from "./bytes.mjs";
import { NODE_TARGETS } from "./targets.mjs";

const LONGEST = 4096;
const LONGEST_SECONDS = 2;
/** Bytes of buffers that a run may leave whatever its input; to these come 1,000 per byte of it. */
const FLOOR = 32 * 2 ** 20;
const MEMORY_PER_BYTE = 1000;
const ENOUGH = 10;
const FOUND = join(ROOT, "crate/fuzz/found");

/**
 * What is shared with the worker: number of the run, length of its input, then the input.
 * @typedef {{ name: string, runs: number, seconds: number, seed: number, replay: string | undefined, shared: SharedArrayBuffer }} Job
 */

/**
 * @param {string} name
 * @param {string} what
 * @param {Uint8Array} input
 */
function tell(name, what, input) {
  mkdirSync(FOUND, { recursive: true });
  const path = join(FOUND, `${name}-${createHash("sha256").update(input).digest("hex").slice(0, 16)}`);
  writeFileSync(path, input);
  console.log(`${name}: ${what}\n  input of ${input.length} bytes: ${path}\n  again with: npm run fuzz -- ${name} --replay ${path}`);
}

function watch() {
  const options = /** @type {const} */ ({
    runs: { type: "string" },
    seconds: { type: "string" },
    seed: { type: "string", default: "1" },
    replay: { type: "string" },
    // What only the runner of Rust knows to do.
    grow: { type: "boolean" },
    careful: { type: "boolean" },
  });
  const { values, positionals } = parseArgs({ options, allowPositionals: true });
  const [name = ""] = positionals;
  const shared = new SharedArrayBuffer(8 + LONGEST);
  /** @type {Job} */
  const job = {
    ...{ name, shared, replay: values.replay, seed: Number(values.seed) },
    runs: Number(values.runs ?? Infinity),
    seconds: Number(values.seconds ?? (values.runs === undefined ? 60 : Infinity)),
  };
  const worker = new Worker(new URL(import.meta.url), { workerData: job, stdout: false });
  const header = new Int32Array(shared, 0, 2);
  let [since, used] = [0, process.cpuUsage()];
  const clock = setInterval(() => {
    const run = header[0] ?? 0;
    const { user, system } = process.cpuUsage(used);
    if (run === since && run !== 0 && user + system > LONGEST_SECONDS * 1e6) {
      tell(name, "a hang: more than two seconds of work", new Uint8Array(shared, 8, header[1]).slice());
      process.exit(1);
    }
    if (run !== since) [since, used] = [run, process.cpuUsage()];
  }, 100);
  worker.on("error", (error) => {
    tell(name, `the worker ended: ${error.message}`, new Uint8Array(shared, 8, header[1]).slice());
    process.exit(1);
  });
  worker.on("message", (/** @type {{ what: string, input: Uint8Array } | { runs: number, seconds: number, faults: number }} */ message) => {
    if ("what" in message) {
      tell(name, message.what, message.input);
      return;
    }
    const { runs, seconds, faults } = message;
    console.log(`${name}: done, ${runs} runs in ${seconds.toFixed(1)} s (${(runs / seconds).toFixed(0)} a second), ${faults} faults, blind`);
    clearInterval(clock);
    process.exitCode = faults > 0 ? 1 : 0;
  });
}

/** @param {Job} job */
async function work({ name, runs, seconds, seed, replay, shared }) {
  const target = NODE_TARGETS.find((each) => each.name === name);
  if (!target) throw new Error(`there is no target ${name}`);
  const body = await target.load();
  const header = new Int32Array(shared, 0, 2);
  const current = new Uint8Array(shared, 8);
  /** @type {Set<string>} */
  const faults = new Set();
  const start = performance.now();
  let run = 0;
  /** @param {Uint8Array} input */
  const attempt = async (input) => {
    run += 1;
    current.set(input);
    header[1] = input.length;
    header[0] = run;
    const before = process.memoryUsage().arrayBuffers;
    /** @type {string | undefined} */
    let what;
    try {
      await body.run(input);
      const held = process.memoryUsage().arrayBuffers - before;
      if (held > FLOOR + MEMORY_PER_BYTE * input.length) what = `too much memory: ${held} bytes`;
    } catch (error) {
      what = error instanceof Error ? (error.stack ?? error.message) : String(error);
    }
    header[0] = 0;
    // Faults of the same place are one.
    const place = what?.split("\n").slice(0, 2).join(" ").replace(/\d+/g, "");
    if (what !== undefined && place !== undefined && !faults.has(place)) {
      faults.add(place);
      parentPort?.postMessage({ what, input });
    }
  };
  if (replay !== undefined) {
    await attempt(Uint8Array.from(readFileSync(replay)));
  } else {
    const seeds = [...(await body.seeds()), new Uint8Array()].map((each) => each.slice(0, LONGEST));
    for (const input of seeds) await attempt(input);
    const random = generator(seed);
    const pick = () => seeds[Math.floor(random() * seeds.length)] ?? new Uint8Array();
    while (run < runs && faults.size < ENOUGH && (performance.now() - start) / 1000 < seconds) {
      await attempt(mutate(pick(), pick(), random, LONGEST));
    }
  }
  parentPort?.postMessage({ runs: run, seconds: (performance.now() - start) / 1000, faults: faults.size });
}

if (isMainThread) watch();
else await work(workerData);
