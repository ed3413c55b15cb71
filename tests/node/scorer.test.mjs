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
 * What the texts of a model and of a submission are, and what is scored of them.
 * @param {any} model
 * @param {string} method
 */
function told(model, method) {
  const says = {
    texts: model.write(),
    submission: model.write(method),
    reports: ["definition", "published"].map((protocol) => model.score(method, protocol)),
  };
  model.free();
  return says;
}

/**
 * The same model read from the texts of one.
 * @param {any} engine
 * @param {ReturnType<typeof told>} says
 * @param {string} method
 */
function reread({ Model }, { texts, submission }, method) {
  /** @param {string} role @param {string} text @param {string} [by] */
  const file = (role, text, by) => {
    const data = new TextEncoder().encode(text);
    const path = `${by ?? "truth"}/PC1_${role}.txt`;
    return { path, role, ...(by ? { method: by } : {}), size: data.length, read: () => data, part: (/** @type {number} */ from, /** @type {number} */ to) => data.slice(from, to) };
  };
  const roles = ["primitives", "parametric", "implicit"];
  const files = [file("cloud", texts.cloud), ...roles.map((role) => file(role, texts[role])), ...roles.map((role) => file(role, submission[role], method))];
  return Model.read("PC1", files);
}

test("the scorer reads, writes and scores as the whole engine does", async () => {
  const [engine, scorer] = [await loadEngine(), await loadScorer()];
  assert.equal(scorer.version(), engine.version());
  for (const { name } of PARTS) {
    const part = engine.Model.generate(name, { spacing: 0.03, seed: 7 });
    const method = part.imperfect(7);
    const made = told(part, method);
    assert.deepEqual(told(reread(scorer, made, method), method), told(reread(engine, made, method), method), name);
  }
});

test("what the page opens with is the first part of the catalogue, to the last digit", async () => {
  const [engine, scorer] = [await loadEngine(), await loadScorer()];
  const [own, first] = [scorer.Model.opening(), engine.Model.generate(PARTS[0].name, {})];
  const method = own.imperfect(1);
  assert.equal(method, first.imperfect(1));
  assert.deepEqual(told(own, method), told(first, method));
});

test("the scorer holds nothing that scoring does not need", async () => {
  const scorer = await loadScorer();
  assert.equal(scorer.Model.prototype.fit, undefined);
  assert.equal(scorer.Model.generate, undefined);
  assert.equal(scorer.HoughLesson, undefined);
});
