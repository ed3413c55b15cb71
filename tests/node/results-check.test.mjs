// What checks pull requests to the standing table, against a server of its own and made-up data.

import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { createHash } from "node:crypto";
import { cpSync, mkdirSync, readFileSync, symlinkSync, writeFileSync } from "node:fs";
import { createServer } from "node:http";
import { join } from "node:path";
import { test } from "node:test";
import { strToU8, zipSync } from "fflate";
import { writeScores } from "../../www/shared/results/scores.mjs";
import { archived, madeUp, methodToml, zipped } from "./standing.mjs";
import { fit4cad } from "./support.mjs";

const CHECK = new URL("../../scripts/results/check.mjs", import.meta.url).pathname;

/**
 * A table with a row, a pull request that adds one, and a server that has the data and the answers.
 * @param {import("node:test").TestContext} t
 */
async function world(t) {
  const { root, data, answers, results } = await madeUp(t);
  const submission = join(root, "submission");
  cpSync(results, submission, { recursive: true });
  /** By the path that is asked for. @type {Partial<Record<string, Uint8Array>>} */
  const served = { "/public.zip": zipped(data), "/mine.zip": zipped(answers) };
  const server = createServer((request, response) => {
    const body = served[request.url ?? ""];
    response.writeHead(body ? 200 : 404).end(body);
  });
  await new Promise((done) => server.listen(0, "127.0.0.1", () => done(undefined)));
  t.after(() => server.close());
  const address = server.address();
  const port = typeof address === "object" && address ? address.port : 0;

  // The table has a row already: what HT finds.
  fit4cad("fit", "--method", "ht", "--out", join(root, "found"), data);
  const there = join(results, "there");
  fit4cad("submit", data, join(root, "found"), "--set", "made-up", "--to", there);
  writeFileSync(join(there, "method.toml"), methodToml({ name: '"There"', answers: '{ called = "HT", licence = "CC0-1.0", fitter = "ht" }' }));
  cpSync(there, join(submission, "there"), { recursive: true });

  const mine = join(submission, "mine");
  const { out } = fit4cad("submit", data, answers, "--set", "made-up", "--to", mine);
  assert.match(out, /written/);
  const sha256 = (/** @type {string} */ path) => createHash("sha256").update(served[path] ?? new Uint8Array()).digest("hex");
  const toml = (/** @type {Record<string, string>} */ other = {}) => writeFileSync(join(mine, "method.toml"), methodToml({ answers: archived(sha256("/mine.zip")), ...other }));
  toml();
  const text = readFileSync(join(mine, "scores.json"), "utf8");
  /** @param {(scores: any) => void} change */
  const scores = (change) => {
    const copy = JSON.parse(text);
    change(copy);
    writeFileSync(join(mine, "scores.json"), writeScores(copy));
  };

  /** @returns {Promise<{ code: number | null, out: string }>} */
  const check = () =>
    new Promise((done) => {
      const mirrors = ["data", "answers"].flatMap((host) => ["--mirror", `https://${host}.example/=http://127.0.0.1:${port}/`]);
      const child = spawn(process.execPath, [CHECK, "--submission", submission, "--table", results, ...mirrors]);
      let said = "";
      child.stdout.on("data", (piece) => (said += piece));
      child.stderr.on("data", (piece) => (said += piece));
      child.on("close", (code) => done({ code, out: said }));
    });
  return { submission, mine, served, toml, scores, text, check };
}

test("a right submission is scored again from its archive and set between its neighbours", async (t) => {
  const { check } = await world(t);
  const { code, out } = await check();
  assert.equal(code, 0, out);
  assert.match(out, /✓ `made-up: 3 of 3 models scored again, every digit the same`/);
  assert.match(out, /### Made up: place 2 of 2 by DSC/);
  assert.match(out, /^\| method \| DSC \| PPV/m);
  // Above it, with the difference to its own figures.
  assert.match(out, /^\| There \| \d\.\d{4} \(−\d\.\d{4}\)/m);
  assert.match(out, /^\| \*\*Mine\*\* \| \d\.\d{4} \|/m);
  assert.match(out, /Every digit was found again\./);
  assert.doesNotMatch(out, /## there/);
});

test("tampered, truncated, missing and doubled submissions are told from each other", async (t) => {
  const { mine, served, toml, scores, text, check, submission } = await world(t);
  const refused = async (/** @type {RegExp} */ expected) => {
    const { code, out } = await check();
    assert.equal(code, 1, out);
    assert.match(out, expected);
    assert.match(out, /Not everything was borne out\./);
  };
  scores((all) => (all.sets[0].models[0].definition.DSC += 1e-9));
  await refused(/✗ `made-up, PC1: definition DSC: claimed 0\.\d+, found 0\.\d+`/);

  writeFileSync(join(mine, "scores.json"), text.slice(0, text.length / 2));
  await refused(/✗ `scores\.json: file: it is no JSON: .*was it cut off\?`/);

  writeFileSync(join(mine, "scores.json"), text);
  const archive = served["/mine.zip"] ?? new Uint8Array();
  served["/mine.zip"] = archive.subarray(0, archive.length - 100);
  await refused(/✗ `https:\/\/answers\.example\/mine\.zip has the SHA-256 [0-9a-f]{64}, not /);
  delete served["/mine.zip"];
  await refused(/✗ `https:\/\/answers\.example\/mine\.zip could not be had: the host answered 404`/);
  // Cut off, and named so: nothing of it can be read.
  served["/mine.zip"] = archive.subarray(0, archive.length / 2);
  toml();
  await refused(/✗ `made-up, PC1: of the answers, the primitives file with the SHA-256 .* is not among the files given`/);

  served["/mine.zip"] = archive;
  toml({ answers: '{ called = "Imperfect", licence = "CC0-1.0", script = "scripts/results/mine.py" }' });
  await refused(/nobody but its author has them: name an archive/);

  toml({ name: '"THERE"' });
  await refused(/✗ `name: there is called There already`/);
  toml();
  const other = JSON.parse(readFileSync(join(submission, "there/scores.json"), "utf8"));
  writeFileSync(join(mine, "scores.json"), writeScores({ ...other, method: "mine" }));
  await refused(/✗ `answers: they are those of there, to the last byte: the row would be a duplicate`/);
  scores((all) => (all.sets[0].models[0].inputs.cloud = "0".repeat(64)));
  await refused(/✗ `made-up: PC1: cloud or ground truth are other files than those that there was scored on`/);
});

test("hostile submissions do no harm and are refused with a word", async (t) => {
  const { mine, served, toml, text, check, submission } = await world(t);
  // Names that lead out of folders, a bomb, an entry beyond all answers: nothing is ever written or run.
  const zeros = new Uint8Array(40 * 2 ** 20);
  served["/mine.zip"] = zipSync({ "../../../../tmp/escaped.txt": strToU8("x"), "/etc/passwd": strToU8("x"), "bomb.txt": zeros, "bombs.zip": zipSync({ "inner.zip": zipSync({ "a.txt": zeros }) }) });
  toml();
  const first = await check();
  assert.equal(first.code, 1);
  assert.match(first.out, /bomb\.txt: 41943040 bytes are more than any answer has; it is left out/);
  assert.match(first.out, /a zip within a zip within a zip is not opened/);
  assert.match(first.out, /is not among the files given/);

  // Markup in names reaches nobody as markup.
  toml({ name: '"<img src=x onerror=alert(1)> [x](http://evil.example) | `c`"' });
  const second = await check();
  assert.match(second.out, /\\<img src=x onerror=alert\(?/);
  assert.doesNotMatch(second.out, /(^|[^\\])<img/m);

  toml({ note: '"a\\n::set-output name=x::y"' });
  assert.match((await check()).out, /✗ `method\.toml: note: expected a text/);
  toml({ answers: archived("0".repeat(64)).replace("https://answers.example", "file:///etc") });
  assert.match((await check()).out, /answers\.archive: expected the address of a zip that begins with https/);

  writeFileSync(join(mine, "scores.json"), " ".repeat(9 * 2 ** 20));
  assert.match((await check()).out, /scores\.json: it has 9437184 bytes; at most 8388608 are read/);
  writeFileSync(join(mine, "scores.json"), text);
  toml();
  writeFileSync(join(mine, "run.sh"), "#!/bin/sh\n");
  mkdirSync(join(submission, "evil"));
  symlinkSync("/etc/passwd", join(submission, "evil/scores.json"));
  symlinkSync("/etc", join(submission, "etc"));
  mkdirSync(join(submission, "Not A Name"));
  const last = await check();
  assert.equal(last.code, 1);
  assert.match(last.out, /✗ `run\.sh: only method\.toml and scores\.json belong in the folder/);
  assert.match(last.out, /✗ `scores\.json: it is a link or a folder; a plain file is needed`/);
  assert.match(last.out, /✗ `etc: only folders of methods belong here/);
  assert.match(last.out, /✗ `Not A Name: only folders of methods belong here/);
  assert.doesNotMatch(last.out, /root:/);
});
