import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { COMMAND, fit4cad, folder, submitted } from "./support.mjs";

test("help goes to stdout and teaches each command", () => {
  for (const args of [["--help"], ["score", "--help"], ["generate", "-h"], ["help", "score"]]) {
    const { code, out, err } = fit4cad(...args);
    assert.deepEqual([code, err], [0, ""]);
    assert.match(out, /^fit4cad/);
    assert.match(out, /Example|Try it/);
  }
  assert.match(fit4cad("score", "--help").out, /swapped: the column headed PPV holds TPR/);
});

test("a wrong call exits with 2, says what was expected and prints no result", () => {
  /** @type {[string[], RegExp][]} */
  const calls = [
    [[], /score/],
    [["scroe"], /no command "scroe"/],
    [["help", "scroe"], /no command "scroe"/],
    [["help", "constructor"], /no command "constructor"/],
    [["toString", "--help"], /no command "toString"/],
    [["score"], /at least one file/],
    [["score", ".", "--format", "xml"], /expected table, json, csv, latex, markdown/],
    [["score", ".", "--json", "--format", "csv"], /--json and --format csv: expected one format/],
    [["fit", ".", "--method", "ht", "--format", "csv"], /expected table, json/],
    [["score", ".", "--protocol", "mine"], /expected definition, published/],
    [["score", ".", "--colour"], /--colour/],
    [["fit"], /--method ht/],
    [["generate"], /--list/],
    [["generate", "teapot"], /no part "teapot"/],
    [["generate", "flange", "--seed", "1.5"], /a whole number/],
    [["generate", "flange", "--noise", "-1"], /--noise -1/],
    [["generate", "flange", "--spacing", "7"], /--spacing 7: expected a number from 0.0005 to 0.1/],
    [["generate", "flange", "--name", "../mine"], /--name ..\/mine: expected/],
  ];
  for (const [args, expected] of calls) {
    const { code, out, err } = fit4cad(...args);
    assert.equal(code, 2, args.join(" "));
    assert.match(err, expected);
    if (args.includes("--json")) assert.match(JSON.parse(out).error, expected);
    else assert.equal(out, "", args.join(" "));
  }
});

test("--json is short for --format json in every command that prints results", (t) => {
  const root = folder(t, submitted("PC1", "MINE"));
  /** @param {string} text */
  const timeless = (text) => JSON.parse(text, (key, value) => (key === "seconds" ? 0 : value));
  for (const command of [["score"], ["check"], ["stats"], ["fit", "--method", "ht"]]) {
    const [long, short, both] = [["--format", "json"], ["--json"], ["--json", "--format=json"]].map((form) => fit4cad(...command, root, ...form));
    assert.deepEqual([long.code, long.err, short.code, short.err], [0, "", 0, ""], command[0]);
    assert.deepEqual(timeless(short.out), timeless(long.out), command[0]);
    assert.deepEqual(timeless(both.out), timeless(long.out), command[0]);
    assert.match(fit4cad(...command, root).out, /^\s*(model|.*\d+ model)/, `${command[0]} prints a table`);
    assert.match(fit4cad(command[0], "--help").out, /--format json +\(--json\)/);
  }
  assert.match(fit4cad("--help").out, /--json for short/);
});

test("every listed part is generated, scores itself and comes out the same again", (t) => {
  const parts = fit4cad("generate", "--list").out.trim().split("\n").map((line) => line.split(" ")[0]);
  assert.ok(parts.length >= 3);
  const [first, second] = [folder(t, {}), folder(t, {})];
  for (const part of parts) {
    for (const out of [first, second]) {
      const { code, err } = fit4cad("generate", part, "--spacing", "0.01", "--seed", "5", "--out", out);
      assert.deepEqual([code, err], [0, ""]);
    }
  }
  const files = readdirSync(first);
  assert.equal(files.length, 4 * parts.length);
  for (const file of files) {
    assert.equal(readFileSync(join(first, file), "utf8"), readFileSync(join(second, file), "utf8"));
  }
  const { code, out } = fit4cad("score", first, "--self", "--format", "json");
  assert.equal(code, 0);
  const reports = JSON.parse(out);
  assert.equal(reports.length, parts.length);
  for (const { model, mean } of reports) {
    // Where faces meet at a tangent, their common edge is found to about a millionth.
    assert.ok(mean.DSC === 1 && mean.dHaus < 1e-5 && mean.d1 === 0, model);
  }
});

test("a reader that leaves early ends the command quietly", async (t) => {
  /** @type {Record<string, string>} */
  const files = {};
  for (let number = 1; number <= 120; number += 1) {
    Object.assign(files, submitted(`PC${number}`, "HT"));
  }
  const args = [COMMAND, "score", folder(t, files), "--format", "json"];
  const child = spawn(process.execPath, args, { stdio: ["ignore", "pipe", "pipe"] });
  let err = "";
  child.stderr.on("data", (chunk) => (err += chunk));
  child.stdout.once("data", () => child.stdout.destroy());
  const code = await new Promise((done) => child.on("close", done));
  assert.equal(err, "");
  assert.equal(code, 0);
});

test("nothing but the result is written when piped", (t) => {
  const { out, err } = fit4cad("score", folder(t, submitted("PC1", "HT")));
  assert.equal(err, "");
  // eslint-disable-next-line no-control-regex -- terminal codes are what is looked for
  assert.doesNotMatch(out, /[\u0000-\u0009\u000b-\u001f\u007f]/);
});

test("every export says the engine's version", (t) => {
  const version = fit4cad("--version").out.trim().replace("fit4cad ", "");
  assert.match(version, /^\d+\.\d+\.\d+/);
  const root = folder(t, submitted("PC1", "HT"));
  const exports = [
    ...["csv", "json", "latex", "markdown"].map((format) => ["score", root, "--format", format]),
    ...["csv", "json"].map((format) => ["stats", root, "--format", format]),
    ["check", root, "--json"],
    ["fit", root, "--method", "ht", "--json"],
  ];
  for (const words of exports) assert.ok(fit4cad(...words).out.replaceAll("\\", "").includes(version), words.join(" "));
});
