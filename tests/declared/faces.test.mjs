// A measure is declared in Rust, and every table, export and help of the command line has it.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { join } from "node:path";
import { before, test } from "node:test";
import { FORMATS } from "../../www/shared/formats/index.mjs";
import { ONE_MORE, checkoutWithOneMoreMeasure } from "./checkout.mjs";

const { key, name } = ONE_MORE;

/** @type {string} */
let checkout;
/** @type {string} */
let demo;

/** @param {string[]} args */
function fit4cad(...args) {
  const command = join(checkout, "bin/fit4cad.mjs");
  const { status, stdout, stderr } = spawnSync(process.execPath, [command, ...args], { encoding: "utf8", maxBuffer: 1 << 28 });
  assert.equal(status, 0, stderr);
  return stdout;
}

before(async () => {
  checkout = await checkoutWithOneMoreMeasure();
  demo = join(checkout, "demo");
  fit4cad("generate", "flange", "--spacing", "0.03", "--imperfect", "--out", demo);
});

/** @returns {import("../../www/shared/formats/results.mjs").Result} */
function scored() {
  const [result] = JSON.parse(fit4cad("score", demo, "--json"));
  return result;
}

/**
 * The figure of the measure, of which the types of this checkout know nothing.
 * @param {object} figures
 */
function figureIn(figures) {
  const found = Object.entries(figures).find(([measure]) => measure === key);
  return Number(found?.[1]);
}

test("it is computed from the points that it is declared to be a ratio of", () => {
  const { primitives, mean } = scored();
  assert.ok(primitives.length > 1);
  for (const primitive of primitives) {
    // TP/(TP+FP+FN) out of 2TP/(2TP+FP+FN).
    const { DSC } = primitive;
    assert.ok(DSC !== null && Math.abs(figureIn(primitive) - DSC / (2 - DSC)) < 1e-12, `${figureIn(primitive)} with DSC ${DSC}`);
  }
  const sum = primitives.reduce((total, primitive) => total + figureIn(primitive), 0);
  assert.ok(Math.abs(figureIn(mean) - sum / primitives.length) < 1e-12);
});

test("every format of results has it, with its figure", () => {
  const figure = figureIn(scored().mean);
  for (const format of Object.keys(FORMATS)) {
    const text = fit4cad("score", demo, "--format", format);
    assert.match(text, new RegExp(`\\b${key}\\b`), format);
    // Tables round, to three digits or to four; the others write all of them.
    const written = [figure.toFixed(3), figure.toFixed(4), String(figure)];
    assert.ok(written.some((digits) => text.includes(digits)), `${format}:\n${text}`);
  }
  const [head = [], row = []] = fit4cad("score", demo, "--format", "csv")
    .split("\r\n")
    .map((line) => line.split(","));
  assert.equal(Number(row[head.indexOf(key)]), figure);
});

test("the help tells what it is", () => {
  const help = fit4cad("score", "--help");
  assert.match(help, new RegExp(`^  ${key} `, "m"));
  assert.ok(help.includes(name));
});
