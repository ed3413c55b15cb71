import assert from "node:assert/strict";
import { test } from "node:test";
import { pageModule } from "./page.mjs";

const { advance, begin, redo, undo } = await pageModule("studio/history.ts");

/**
 * @param {string | number} state
 * @param {string} [merge]
 */
const step = (state, merge) => ({ state, name: `make it ${state}`, ...(merge ? { merge } : {}) });

test("what was done is undone and done again, step by step", () => {
  const history = advance(advance(begin("a"), step("b")), step("c"));
  assert.equal(history.present.state, "c");
  const back = undo(undo(history));
  assert.equal(back.present.state, "a");
  assert.equal(undo(back), back);
  const again = redo(redo(back));
  assert.deepEqual(again, history);
  assert.equal(redo(again), again);
});

test("a new step forgets what had been undone", () => {
  const history = advance(undo(advance(begin("a"), step("b"))), step("c"));
  assert.equal(redo(history), history);
  assert.equal(undo(history).present.state, "a");
});

test("the many values of one field are one step, but not across an undo or another field", () => {
  const typed = advance(advance(begin(1), step(2, "noise")), step(3, "noise"));
  assert.equal(undo(typed).present.state, 1);
  const other = advance(typed, step(4, "seed"));
  assert.equal(undo(other).present.state, 3);
  const later = advance(undo(advance(typed, step(5, "noise"))), step(6, "noise"));
  assert.equal(undo(later).present.state, 1);
});

test("the name of a step says what was done", () => {
  assert.equal(advance(begin("a"), step("b")).present.name, "make it b");
});
