// A thread of `--jobs`: does its share of the models.

import { once } from "node:events";
import { parentPort, workerData } from "node:worker_threads";
import { loadEngine } from "./engine.mjs";
import { evaluateEach, reportOf } from "./evaluate.mjs";
import { fitEach, writeSubmission } from "./fitting.mjs";
import { collect } from "./inputs.mjs";

/** @type {import("./jobs.mjs").WorkerData} */
const { paths, files: count, claims, order } = workerData;
const port = /** @type {import("node:worker_threads").MessagePort} */ (parentPort);

/** @param {import("./jobs.mjs").Told} told */
const tell = (told) => port.postMessage(told);

const engine = await loadEngine();
const { files } = await collect(paths);
if (files.length !== count) {
  throw new Error("files came or went while they were listed; try again");
}
tell({ listed: true });
await once(port, "message");

const shared = {
  claim: (/** @type {number} */ index) => Atomics.compareExchange(claims, index, 0, 1) === 0,
  progress: (/** @type {string} */ place) => tell({ place }),
};
if (order.task === "score") {
  const { models, stops } = await evaluateEach(engine, files, { ...order.request, ...shared, report: reportOf(order.request.by) });
  tell({ answer: { models, stops } });
} else {
  const { out, ...settings } = order.request;
  const { models, stops } = await fitEach(engine, files, {
    ...settings,
    ...shared,
    take: (able, model, method, texts) => out !== undefined && writeSubmission(able, out, model, method, texts),
  });
  tell({ answer: { models, stops } });
}
