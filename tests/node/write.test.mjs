// Files are written whole, whoever else writes beside.

import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { Worker } from "node:worker_threads";
import { folder } from "./support.mjs";

const THREADS = 2;
const FILES = 12;
/** So long that writing one takes longer than a thread may have to wait for a processor. */
const WORDS = 400_000;

/** Writes its files one by one, each at the moment at which the other threads write theirs. */
const WRITER = `
  import { join } from "node:path";
  import { workerData } from "node:worker_threads";
  const { module, folder, name, threads, files, words, arrived } = workerData;
  const { writeWhole } = await import(module);
  for (let file = 0; file < files; file += 1) {
    Atomics.add(arrived, 0, 1);
    while (Atomics.load(arrived, 0) < threads * (file + 1));
    writeWhole(join(folder, name + file + ".txt"), (name + file + " ").repeat(words));
  }
`;

test("threads that write into one folder at once do not come upon each other's unfinished files", async (t) => {
  const root = folder(t, {});
  const arrived = new Int32Array(new SharedArrayBuffer(4));
  const names = Array.from({ length: THREADS }, (_, at) => `thread${at}-`);
  const ends = names.map((name) => {
    const module = new URL("../../bin/cli/write.mjs", import.meta.url).href;
    const source = new URL(`data:text/javascript,${encodeURIComponent(WRITER)}`);
    const worker = new Worker(source, { workerData: { module, folder: root, name, threads: THREADS, files: FILES, words: WORDS, arrived } });
    return new Promise((resolve, reject) => void worker.on("error", reject).on("exit", resolve));
  });
  await Promise.all(ends);
  assert.equal(readdirSync(root).length, THREADS * FILES);
  for (const name of names) {
    for (let file = 0; file < FILES; file += 1) {
      assert.equal(readFileSync(join(root, `${name}${file}.txt`), "utf8"), `${name}${file} `.repeat(WORDS));
    }
  }
});
