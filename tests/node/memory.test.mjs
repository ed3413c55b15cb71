// What reading costs in memory, seen from outside: how far the module's memory grew.

import assert from "node:assert/strict";
import { createHash } from "node:crypto";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { gzipSync } from "node:zlib";
import { zipSync } from "fflate";
import { loadEngineApart } from "../../bin/cli/engine.mjs";
import { memory as source } from "../../www/shared/zip/source.mjs";
import { STREAMED, listZip } from "../../www/shared/zip/zip.mjs";
import { held } from "../../scripts/lib/input.mjs";
import { generator } from "./random.mjs";
import { fit4cad, folder } from "./support.mjs";

const POINTS = 200_000;
const BYTES_PER_POINT = 24;

function largeCloud() {
  const random = generator(1);
  const coordinate = () => String(random() * 100 - 50);
  const lines = Array.from({ length: POINTS }, () => `[${coordinate()}, ${coordinate()}, ${coordinate()}]`);
  return new TextEncoder().encode(`Points:=[\n${lines.join(", \n")} \n ];\n`);
}

test("a cloud is read in less than twice its file and the points themselves", async () => {
  const { engine, memory } = await loadEngineApart();
  const bytes = largeCloud();
  const before = memory.buffer.byteLength;
  const model = engine.Model.read("PC1", [held({ path: "PC1.txt", role: "cloud" }, bytes)]);
  const grown = memory.buffer.byteLength - before;
  assert.equal(model.info().points, POINTS);
  assert.ok(grown < 2 * bytes.length + BYTES_PER_POINT * POINTS, `${grown} bytes for a file of ${bytes.length}`);
});

/** Rows of a plane, more bytes than are held together, with a broken one far behind. */
function longCloud() {
  const random = generator(2);
  const lines = Array.from({ length: 500_000 }, () => `${(random() * 100).toFixed(6)} ${(random() * 100).toFixed(6)} 0.000000\n`);
  lines[400_000] = "1.0 x 2.0\n";
  return lines.join("");
}

test("a long text is read in pieces, in hardly more memory than its points take, and tells the right line", async () => {
  const { engine, memory } = await loadEngineApart();
  const bytes = new TextEncoder().encode(longCloud());
  const before = memory.buffer.byteLength;
  let most = 0;
  const file = {
    ...held({ path: "long.xyz", role: "cloud" }, bytes),
    read: () => assert.fail("it is asked for whole"),
    part: (/** @type {number} */ from, /** @type {number} */ to) => {
      most = Math.max(most, to - from);
      return bytes.subarray(from, to);
    },
  };
  const model = engine.Model.read("long", [file]);
  const grown = memory.buffer.byteLength - before;
  const { points, diagnostics } = model.info();
  assert.deepEqual([points, diagnostics.length, diagnostics[0]?.line, diagnostics[0]?.column], [499_999, 1, 400_001, 5]);
  // A few pieces of 4 MiB come and go.
  assert.ok(grown < BYTES_PER_POINT * points + 2 ** 24, `${grown} bytes for ${points} points`);
  assert.ok(most < bytes.length / 2, `${most} bytes at once`);
});

test("a long text that is packed, by gzip or in a zip, takes no more", async () => {
  const text = new TextEncoder().encode(longCloud());
  const zip = zipSync({ "long.xyz": text });
  const entry = listZip(source(zip), STREAMED).entries[0];
  assert.ok(entry);
  const packed = gzipSync(text);
  for (const file of [
    { path: "long.xyz.gz", size: packed.length, part: (/** @type {number} */ from, /** @type {number} */ to) => packed.subarray(from, to) },
    { path: "a.zip/long.xyz", size: entry.size, part: entry.part },
  ]) {
    const { engine, memory } = await loadEngineApart();
    const before = memory.buffer.byteLength;
    const model = engine.Model.read("long", [{ ...file, role: "cloud", read: () => assert.fail("it is asked for whole") }]);
    const grown = memory.buffer.byteLength - before;
    const { points, diagnostics } = model.info();
    assert.deepEqual([points, diagnostics.length, diagnostics[0]?.line, diagnostics[0]?.column], [499_999, 1, 400_001, 5], file.path);
    assert.ok(grown < BYTES_PER_POINT * points + 2 ** 24 + 2 ** 23, `${grown} bytes for ${points} points of ${file.path}`);
  }
});

test("the command line reads in pieces what it hashes, and tells the hash of all of it", (t) => {
  const root = folder(t, { "long.xyz": longCloud(), "long_labels.txt": "0\n".repeat(500_000), "HT/long_labels.txt": "0\n".repeat(500_000) });
  const { out, err } = fit4cad("score", "--json", root);
  const [report] = JSON.parse(out);
  assert.equal(report?.mean.DSC, 1, err);
  for (const { path, sha256 } of report.files) {
    assert.equal(sha256, createHash("sha256").update(readFileSync(path)).digest("hex"), path);
  }
  assert.deepEqual(report.files.map((/** @type {any} */ { path }) => path), ["long.xyz", "long_labels.txt", "HT/long_labels.txt"].map((path) => join(root, path)));
});
