// Rust modules that use each other in a circle are found.

import assert from "node:assert/strict";
import { join } from "node:path";
import { test } from "node:test";
import { circles } from "../../scripts/lib/rust-modules.mjs";
import { folder } from "./support.mjs";

/**
 * The circles of a crate of these files, each as the modules it goes through.
 * @param {import("node:test").TestContext} t
 * @param {Record<string, string>} files
 */
function found(t, files) {
  return circles(join(folder(t, files), "lib.rs")).map((circle) => circle.map(({ from }) => from.replace("crate::", "")).toSorted((a, b) => a.localeCompare(b)));
}

test("two files that name each other are a circle, told with the lines that make it", (t) => {
  const root = folder(t, {
    "lib.rs": "mod one;\nmod two;\n",
    "one.rs": "use crate::two::Two;\npub struct One(Two);\n",
    "two.rs": "// Not this: crate::one\npub struct Two;\nfn of(one: &super::one::One) {}\n",
  });
  const [circle = [], ...others] = circles(join(root, "lib.rs"));
  assert.deepEqual(others, []);
  assert.deepEqual(
    circle.map(({ from, path, line }) => `${line}: ${from} uses ${path}`).toSorted((a, b) => a.localeCompare(b)),
    ["1: crate::one uses crate::two::Two", "3: crate::two uses super::one::One"],
  );
});

test("a circle is seen through what a folder shows of its parts, and through its parts", (t) => {
  const files = {
    "lib.rs": "mod low;\nmod high;\n",
    "high/mod.rs": "mod inner;\npub use inner::{Inner as Shown, other};\n",
    "high/inner.rs": "use crate::low::{self, Low};\npub struct Inner(Low);\n",
    "low.rs": "use super::high::{\n    Shown,\n};\npub struct Low;\n",
  };
  assert.deepEqual(found(t, files), [["high::inner", "low"]]);
  const whole = { ...files, "high/mod.rs": "mod inner;\npub fn all() { inner::run() }\n", "low.rs": "use crate::high::all;\n" };
  assert.deepEqual(found(t, whole), [["high", "high::inner", "low"]]);
});

test("what parts use of what they are in is no circle, nor what tests use", (t) => {
  const files = {
    "lib.rs": "mod part;\nmod other;\npub struct Shared;\npub fn run() { part::run() }\n",
    "part.rs": "use crate::Shared;\npub fn run() {}\n#[cfg(test)]\nmod tests {\n    use crate::other::that;\n}\n",
    "other.rs": "use crate::part::run;\nconst NAME: &str = \"crate::part\";\nfn of<'a>(x: &'a str) -> char { '\"' }\n",
  };
  assert.deepEqual(found(t, files), []);
});
