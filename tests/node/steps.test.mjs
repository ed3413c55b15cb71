// What the test run tells at its end of the tests that failed.

import assert from "node:assert/strict";
import { test } from "node:test";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { marked } from "../../scripts/lib/run.mjs";
import { count, failedFiles, faults, runNodeTests } from "../../scripts/lib/steps.mjs";

const CARGO = `
running 2 tests
test plane::fits ... ok
test cone::fits ... FAILED

failures:

---- cone::fits stdout ----

thread 'cone::fits' panicked at src/cone.rs:7:5:
assertion failed: angle > 0.0

failures:
    cone::fits

test result: FAILED. 1 passed; 1 failed; 0 ignored; 0 measured; 0 filtered out; finished in 0.00s
`;

const NODE = `✔ a plane is fitted (1.2ms)
✖ a cone is fitted (3.4ms)
ℹ tests 2
ℹ pass 1
ℹ fail 1
ℹ skipped 0

✖ failing tests:

test at tests/node/fit.test.mjs:10:1
✖ a cone is fitted (3.4ms)
  AssertionError: 1 !== 2
`;

const PLAYWRIGHT = `  ✘  2 view.spec.ts:9:1 › a cone is drawn (1.0s)


  1) view.spec.ts:9:1 › a cone is drawn ─────

    Error: expected a cone

  1 failed
    view.spec.ts:9:1 › a cone is drawn
  1 passed (5.0s)
`;

const PYTEST = `..F
=================================== FAILURES ===================================
____ test_cone ____
E   assert 1 == 2
=========================== short test summary info ============================
FAILED test_fit.py::test_cone - assert 1 == 2
========================= 1 failed, 2 passed in 0.10s ==========================
`;

/** @type {[import("../../scripts/lib/steps.mjs").Runner, string, RegExp][]} */
const RUNNERS = [
  ["cargo", CARGO, /panicked at src\/cone\.rs:7:5:\nassertion failed/],
  ["node", NODE, /test at tests\/node\/fit\.test\.mjs:10:1/],
  ["playwright", PLAYWRIGHT, /Error: expected a cone/],
  ["pytest", PYTEST, /FAILED test_fit\.py::test_cone/],
];

for (const [runner, output, reason] of RUNNERS) {
  test(`of ${runner} a failed test is counted and told with its reason, not those that pass`, () => {
    assert.equal(count(runner, output).failed, 1);
    const told = faults(runner, `\u001b[31m${output}\u001b[0m`);
    assert.match(told, reason);
    assert.doesNotMatch(told, /plane/);
  });
}

test("of a step that tells no faults, or too many, so much is told as is read", () => {
  const many = Array.from({ length: 500 }, (_, line) => `line ${line}`).join("\n");
  const last = faults(undefined, many).split("\n");
  assert.equal(last.at(-2), "line 499");
  assert.match(last.at(-1) ?? "", /^… 440 lines more above$/);
  const first = faults("node", `✖ failing tests:\n${many}`).split("\n");
  assert.equal(first[1], "line 0");
  assert.equal(first.length, 61);
});

test("a file of tests that passes once it is run alone fails no run, and is told", async (t) => {
  const folder = mkdtempSync(join(tmpdir(), "fit4cad-steps-"));
  t.after(() => rmSync(folder, { recursive: true, force: true }));
  /** @param {string} name @param {string} body */
  const file = (name, body) => {
    const path = join(folder, `${name}.test.mjs`);
    writeFileSync(path, `import { test } from "node:test";\nimport fs from "node:fs";\ntest("${name}", () => {${body}});\n`);
    return path;
  };
  const mark = JSON.stringify(join(folder, "mark"));
  const flaky = file("flaky", `if (!fs.existsSync(${mark})) { fs.writeFileSync(${mark}, ""); throw new Error("busy"); }`);
  const well = file("well", "");
  // Else Node takes what is run below for a part of this run.
  delete process.env.NODE_TEST_CONTEXT;
  // And what they print for what this run says of itself.
  const within = (/** @type {string[]} */ files) => marked("│ ", () => runNodeTests(files));
  const output = await within([flaky, well]);
  assert.deepEqual(count("node", output), { passed: 2, failed: 0, skipped: 0, repeated: 1 });
  assert.match(faults("node", output), /Error: busy/);
  await assert.rejects(within([file("broken", 'throw new Error("always");'), well]));
  assert.deepEqual(failedFiles(NODE), ["tests/node/fit.test.mjs"]);
});
