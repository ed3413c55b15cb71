// The page starts with the scorer and fetches the whole engine later: both must say the same, to the last digit.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { PARTS } from "../../www/generated/declared/parts.js";
import { loadEngine } from "../../bin/cli/engine.mjs";

const GENERATED = new URL("../../www/generated/scorer/", import.meta.url);

async function loadScorer() {
  const scorer = await import(new URL("scorer.js", GENERATED).href);
  scorer.initSync({ module: readFileSync(new URL("scorer_bg.wasm", GENERATED)) });
  return scorer;
}

/**
 * A part, its texts and the scores of an imperfect submission.
 * @param {any} engine
 * @param {string} part
 * @param {string} protocol
 */
function told({ Model }, part, protocol) {
  const model = Model.generate(part, { spacing: 0.03, seed: 7 });
  const method = model.imperfect(7);
  const says = { texts: model.write(), submission: model.write(method), report: model.score(method, protocol) };
  model.free();
  return says;
}

test("the scorer generates, writes and scores as the whole engine does", async () => {
  const [engine, scorer] = [await loadEngine(), await loadScorer()];
  assert.equal(scorer.version(), engine.version());
  for (const { name } of PARTS) {
    for (const protocol of ["definition", "published"]) {
      assert.deepEqual(told(scorer, name, protocol), told(engine, name, protocol), `${name}, ${protocol}`);
    }
  }
});

test("the scorer holds nothing that scoring does not need", async () => {
  const scorer = await loadScorer();
  assert.equal(scorer.Model.prototype.fit, undefined);
  assert.equal(scorer.HoughLesson, undefined);
});
