// Workers of the page, played by stand-ins: what was asked of one that ends is answered all the same.

import assert from "node:assert/strict";
import { after, test } from "node:test";
import { MessageChannel } from "node:worker_threads";
import * as Comlink from "comlink";
// @ts-expect-error the adapter comes without types
import nodeEndpoint from "comlink/dist/esm/node-adapter.mjs";
import { pageModule } from "./page.mjs";

const { LiveWorker } = await pageModule("engine/live-worker.ts");
const { WorkerPool } = await pageModule("engine/pool.ts");
const { Queue } = await pageModule("engine/queue.ts");

/**
 * @typedef {Record<string, (value?: any) => any>} Api what a stand-in answers
 * @typedef {(reason: Error) => void} OnEnd
 */

/**
 * Locks that are taken when the stand-in that holds them is gone.
 * @type {Map<string, () => void>}
 */
const waiting = new Map();
Object.defineProperty(globalThis, "navigator", {
  value: { locks: { request: (/** @type {string} */ name, /** @type {() => void} */ taken) => void waiting.set(name, taken) } },
  configurable: true,
});

/** @type {import("node:worker_threads").MessagePort[]} */
const ports = [];
after(() => ports.forEach((port) => port.close()));

/** A worker that answers from this thread. `die` ends it as a browser does that has run out of memory. */
class StandIn extends EventTarget {
  ended = false;

  /**
   * @param {string} name
   * @param {Api} api
   */
  constructor(name, api) {
    super();
    this.name = name;
    const { port1, port2 } = new MessageChannel();
    Comlink.expose(api, nodeEndpoint(port2));
    this.port = port1;
    ports.push(port1);
    port1.on("message", (data) => this.dispatchEvent(new MessageEvent("message", { data })));
  }

  /** @param {unknown} message */
  postMessage(message) {
    this.port.postMessage(message);
  }

  terminate() {
    this.ended = true;
    this.port.close();
  }

  liveOn() {
    this.dispatchEvent(new MessageEvent("message", { data: "alive" }));
  }

  die() {
    this.port.close();
    waiting.get(this.name)?.();
  }
}

/** @type {Api} */
const api = {
  double: (value) => 2 * value,
  never: () => new Promise(() => undefined),
  exhaust() {
    throw new RangeError("Array buffer allocation failed");
  },
};

/** @param {OnEnd} [onEnd] */
function started(onEnd) {
  /** @type {StandIn[]} */
  const made = [];
  const start = (/** @type {string} */ name) => {
    made.push(new StandIn(name, api));
    return made[0];
  };
  const worker = new LiveWorker(start, { title: "The engine", onEnd });
  made[0].liveOn();
  return { worker, standIn: made[0] };
}

test("a worker answers, also when its errors are answers", async () => {
  const { worker } = started();
  assert.equal(await worker.api.double(21), 42);
  await assert.rejects(worker.api.exhaust(), /allocation failed/);
  assert.equal(await worker.api.double(1), 2);
  worker.end();
  await assert.rejects(worker.api.double(1), { name: "WorkerEnded", message: "The engine was stopped." });
});

/** @type {Record<string, readonly [end: (standIn: StandIn) => void, message: string]>} */
const ends = {
  "cannot be started": [(standIn) => standIn.dispatchEvent(new Event("error")), "The engine could not be started."],
  "sends what cannot be read": [(standIn) => standIn.dispatchEvent(new Event("messageerror")), "An answer of The engine could not be read."],
  "ends without a word": [(standIn) => standIn.die(), "The engine ended without a word. The browser may have run out of memory."],
};

for (const [how, [end, message]] of Object.entries(ends)) {
  test(`what was asked of a worker that ${how} fails with the reason, and is told of once`, async () => {
    /** @type {string[]} */
    const told = [];
    const { worker, standIn } = started((reason) => told.push(reason.message));
    const [one, other] = [worker.api.never(), worker.api.never()];
    end(standIn);
    await assert.rejects(one, { name: "WorkerEnded", message });
    await assert.rejects(other, { message });
    await assert.rejects(worker.api.double(1), { message });
    assert.deepEqual(told, [message]);
    assert.ok(standIn.ended);
    waiting.get(standIn.name)?.();
    assert.equal(told.length, 1);
  });
}

/** @param {number} size */
function pool(size) {
  /** @type {StandIn[]} */
  const standIns = [];
  const spawn = (/** @type {OnEnd} */ onEnd) => {
    const { worker, standIn } = started(onEnd);
    standIns.push(standIn);
    return worker;
  };
  return { engine: new WorkerPool(spawn, size), standIns };
}

test("after a job that used up the memory, the next have a fresh worker", async () => {
  const { engine, standIns } = pool(1);
  const [first, second, third] = ["double", "exhaust", "double"].map((name, at) => engine.run((/** @type {Api} */ api) => api[name](at)));
  assert.equal(await first, 0);
  await assert.rejects(second, /allocation failed/);
  assert.equal(await third, 4);
  assert.deepEqual(standIns.map(({ ended }) => ended), [true, false]);
});

test("a worker that ends in the middle of a job loses that job alone", async () => {
  const { engine, standIns } = pool(1);
  const lost = engine.run((/** @type {Api} */ api) => api.never());
  const next = engine.run((/** @type {Api} */ api) => api.double(3));
  standIns[0].die();
  await assert.rejects(lost, /without a word/);
  assert.equal(await next, 6);
  // One that ends while it has nothing to do is not asked again.
  standIns[1].die();
  assert.equal(await engine.run((/** @type {Api} */ api) => api.double(4)), 8);
  assert.equal(standIns.length, 3);
});

test("what is aborted ends its worker or leaves the queue, and what waits goes on", async () => {
  const { engine, standIns } = pool(1);
  const stop = new AbortController();
  const all = ["never", "double"].map((name) => engine.run((/** @type {Api} */ api) => api[name](1), { signal: stop.signal }));
  const other = engine.run((/** @type {Api} */ api) => api.double(5));
  stop.abort(new Error("enough"));
  for (const each of all) await assert.rejects(each, /enough/);
  assert.equal(await other, 10);
  assert.deepEqual(standIns.map(({ ended }) => ended), [true, false]);
  await assert.rejects(engine.run((/** @type {Api} */ api) => api.double(1), { signal: stop.signal }), /enough/);
});

test("the urgent go first, and who is hastened goes with them", async () => {
  const { engine } = pool(1);
  /** @type {string[]} */
  const order = [];
  /**
   * @param {string} name
   * @param {"idle" | "background"} [urgency]
   */
  const job = (name, urgency) => engine.run(async (/** @type {Api} */ api) => order.push(`${name} ${await api.double(1)}`), { urgency, name });
  const jobs = [job("first"), job("idle", "idle"), job("a", "background"), job("b", "background"), job("urgent")];
  engine.hasten("b");
  engine.hasten("unknown");
  await Promise.all(jobs);
  assert.deepEqual(order, ["first 2", "urgent 2", "b 2", "a 2", "idle 2"]);
});

test("a queue of a hundred thousand is filled, thinned and emptied in no time to speak of", () => {
  const queue = new Queue();
  const jobs = Array.from({ length: 100_000 }, (_, at) => ({ at }));
  for (const job of jobs) queue.put(job, "background");
  for (const job of jobs) if (job.at % 2 === 0) queue.remove(job);
  queue.put(jobs[99_999], "foreground");
  assert.equal(queue.size, 50_000);
  const taken = [];
  for (let job = queue.take(); job; job = queue.take()) taken.push(job.at);
  assert.equal(taken[0], 99_999);
  assert.deepEqual(taken.slice(1), jobs.filter(({ at }) => at % 2 === 1 && at < 99_999).map(({ at }) => at));
});
