// A native build and the wasm that everybody runs agree to the last digit.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { test } from "node:test";
import { loadEngine } from "../../bin/cli/engine.mjs";
import { ROOT } from "../../scripts/lib/paths.mjs";

/** @typedef {import("../../bin/engine/engine.js").SampleOptions} SampleOptions */
/** @typedef {import("../../bin/engine/engine.js").Texts} Texts */

const engine = await loadEngine();

/**
 * FNV-1a of 32 bits.
 * @param {string} text
 */
function checksum(text) {
  const bytes = new TextEncoder().encode(text);
  return bytes.reduce((hash, byte) => Math.imul(hash ^ byte, 0x01000193), 0x811c9dc5) >>> 0;
}

/** @param {Texts} texts */
const told = ({ primitives, parametric, implicit }) => ({ primitives: checksum(primitives), parametric, implicit });

/**
 * What `crate/fit4cad/examples/digits.rs` says of a part.
 * @param {string} part
 * @param {SampleOptions} options
 */
function digits(part, options) {
  const model = engine.Model.generate(part, options);
  const truth = model.write();
  /** @param {"ht" | "pg"} method */
  const fitted = (method) => {
    const name = model.fit(method, {}, 1, () => {});
    const means = /** @type {const} */ (["definition", "published"]).map((protocol) =>
      Object.values(model.score(name, protocol).mean),
    );
    return { texts: told(model.write(name)), means };
  };
  const found = { HT: fitted("ht"), PG: fitted("pg") };
  const cloud = checksum(model.cloud());
  model.free();
  return { part, options, cloud, truth: told(truth), found };
}

test("every part is generated, fitted and scored to the same digits natively and under wasm", () => {
  const { status, stdout, stderr } = spawnSync(
    "cargo",
    ["run", "--quiet", "--locked", "--package", "fit4cad", "--example", "digits"],
    { cwd: ROOT, encoding: "utf8", maxBuffer: 1 << 28 },
  );
  assert.equal(status, 0, stderr);
  /** @type {ReturnType<typeof digits>[]} */
  const native = JSON.parse(stdout);
  assert.ok(native.length > 20, stdout);
  for (const expected of native) {
    const { part, options } = expected;
    assert.deepEqual(digits(part, options), expected, `${part}, noise ${options.noise}`);
  }
});
