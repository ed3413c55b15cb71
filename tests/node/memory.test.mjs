// What reading costs in memory, seen from outside: how far the module's memory grew.

import assert from "node:assert/strict";
import { test } from "node:test";
import { loadEngineApart } from "../../bin/cli/engine.mjs";
import { held } from "../../scripts/lib/input.mjs";
import { generator } from "./random.mjs";

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
