// The standing table: its files, and the commands that write and verify them.

import assert from "node:assert/strict";
import { existsSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { methodsIn, readFolder, setsOf } from "../../bin/cli/standing/folder.mjs";
import { differencesOf } from "../../www/shared/results/compare.mjs";
import { feedOf } from "../../www/shared/results/feed.mjs";
import { readMethod } from "../../www/shared/results/method.mjs";
import { readScores, writeScores } from "../../www/shared/results/scores.mjs";
import { readSets } from "../../www/shared/results/sets.mjs";
import { madeUp, methodToml, SETS } from "./standing.mjs";
import { fit4cad, folder, PUBLIC_FILES, WITHOUT_PUBLIC_FILES } from "./support.mjs";

const RESULTS = new URL("../../results", import.meta.url).pathname;

/** @param {readonly { where: string, message: string }[]} findings */
const told = (findings) => findings.map(({ where, message }) => `${where}: ${message}`).join("\n");

test("every row of the table is whole, and what it says of the same models is of the same files", () => {
  const sets = setsOf();
  const rows = methodsIn().map((id) => readFolder(join(RESULTS, id), sets));
  assert.ok(rows.length >= 5);
  /** @type {Map<string, string>} */
  const inputs = new Map();
  for (const { id, scores, findings } of rows) {
    assert.equal(told(findings), "", id);
    for (const { set, models } of scores?.sets ?? []) {
      for (const entry of models) {
        const key = `${set} ${entry.model}`;
        const hashes = JSON.stringify(entry.inputs);
        assert.equal(inputs.get(key) ?? hashes, hashes, `${id}, ${key}`);
        inputs.set(key, hashes);
      }
    }
  }
});

test("what is wrong with a method.toml is said key by key", () => {
  assert.deepEqual(readMethod(methodToml()).findings, []);
  /** @type {[Record<string, string>, RegExp][]} */
  const wrong = [
    [{ name: '"two\\nlines"' }, /^name: expected a text .* in one line/],
    [{ name: `"${"x".repeat(61)}"` }, /^name: expected a text of at most 60/],
    [{ year: '"new"' }, /^year: expected a whole number of at least 1950 and of at most 2100, found "new"$/],
    [{ kind: '"magic"' }, /^kind: expected hough, growing, ransac, learned, other, found "magic"$/],
    [{ added: '"soon"' }, /^added: expected a day/],
    [{ code: '"javascript:alert(1)"' }, /^code: expected an address that begins with https/],
    [{ colour: '"red"' }, /^"colour": there is no such key here/],
    [{ authors: '[{ given = "A" }]' }, /^authors\[1\]\.family: expected/],
    [{ answers: '{ called = "M", licence = "X" }' }, /^answers\.archive: expected exactly one of archive, public, fitter and script/],
    [{ answers: '{ called = "M", licence = "X", archive = "http://a.example/b.zip", sha256 = "0" }' }, /^answers\.archive: .*\nanswers\.sha256: /],
    [{ answers: '{ called = "M", licence = "X", script = "../../etc/x.py" }' }, /^answers\.script: expected a script of this repository/],
    [{ name: '"unclosed' }, /^line 1, column \d+: /],
  ];
  for (const [other, expected] of wrong) assert.match(told(readMethod(methodToml(other)).findings), expected);
  assert.match(told(readMethod(`name = "${"x".repeat(70_000)}"`).findings), /more than 65536 characters/);
});

test("sets are ranges of models, or worse scans of a set before them", () => {
  const { sets, findings } = readSets(SETS);
  assert.equal(told(findings), "");
  assert.deepEqual(sets.map(({ id, models, degraded }) => [id, models, degraded]), [
    ["made-up", ["PC1", "PC2", "PC3"], undefined],
    ["made-up-noise", ["PC1", "PC2", "PC3"], { noise: 0.001, seed: 3 }],
  ]);
  assert.match(told(readSets(SETS.replace("[[1, 3]]", "[[3, 1]]")).findings), /expected ranges of numbers/);
  assert.match(told(readSets(SETS.replace("noise = 0.001", "noise = 7")).findings), /degraded\.noise: expected a number/);
  assert.match(told(readSets(SETS.replace('of = "made-up"', 'of = "nothing"')).findings), /expected a set before this one/);
});

test("a submission is checked step by step, scored and verified to the last digit; a changed figure is named", async (t) => {
  const { data, answers, results } = await madeUp(t);
  const mine = join(results, "mine");
  const first = fit4cad("submit", data, answers, "--set", "made-up", "--to", mine);
  assert.equal(first.code, 1);
  assert.match(first.out, /^✓ 3 models of the set made-up.*\n✓ 3 answers of Imperfect/);
  assert.match(first.out, /✗ method\.toml: kind: expected hough/);
  writeFileSync(join(mine, "method.toml"), methodToml());
  const again = fit4cad("submit", data, answers, "--set", "made-up", "--to", mine);
  assert.equal(again.code, 0, again.out + again.err);

  const verified = fit4cad("verify", mine, "--data", data, "--answers", answers);
  assert.match(verified.out, /^✓ mine: made-up: 3 of 3 models scored again, every digit the same\n$/);
  assert.equal(verified.code, 0);

  // A worse scan is made here, with what was answered to it.
  const worse = join(results, "../worse");
  const degraded = fit4cad("degrade", data, "--noise", "0.001", "--seed", "3", "--out", worse);
  assert.equal(degraded.code, 0, degraded.err);
  const both = fit4cad("submit", worse, answers, "--set", "made-up-noise", "--to", mine);
  assert.match(both.out, /written: .*with made-up, made-up-noise/);
  const twice = fit4cad("verify", mine, "--data", data, "--answers", answers);
  assert.equal(twice.code, 0, twice.out);

  const path = join(mine, "scores.json");
  const scores = JSON.parse(readFileSync(path, "utf8"));
  const entry = scores.sets[0].models[1];
  const claimed = entry.definition.DSC;
  entry.definition.DSC = 1;
  scores.sets[0].summary.figures.spfn.mean += 1e-15;
  writeFileSync(path, writeScores(scores));
  const tampered = fit4cad("verify", mine, "--data", data, "--answers", answers);
  assert.equal(tampered.code, 1);
  assert.ok(tampered.out.includes(`made-up, PC2: definition DSC: claimed 1, found ${claimed}`), tampered.out);
  assert.match(tampered.out, /made-up, all models: summary figures spfn mean: claimed/);
  assert.match(tampered.out, /✓ mine: made-up-noise/);
  const json = JSON.parse(fit4cad("verify", mine, "--data", data, "--answers", answers, "--json").out);
  assert.deepEqual(json[0].outcomes[0].differences[0], { model: "PC2", figure: "definition DSC", claimed: 1, found: claimed });
});

test("other files than those that were scored, and those that are missing, are named", async (t) => {
  const { data, answers, results } = await madeUp(t);
  const mine = join(results, "mine");
  fit4cad("submit", data, answers, "--set", "made-up", "--to", mine);
  writeFileSync(join(mine, "method.toml"), methodToml());
  const answer = join(answers, "pointCloud_primitives_Imperfect/PC2_primitives.txt");
  writeFileSync(answer, readFileSync(answer, "utf8").replace("[", "[1 "));
  rmSync(join(data, "pointCloud/PC3.txt"));
  const { code, out } = fit4cad("verify", mine, "--data", data, "--answers", answers);
  assert.equal(code, 1);
  assert.match(out, /PC2: of the answers, the primitives file with the SHA-256 [0-9a-f]{12}… is not among the files given/);
  assert.match(out, /PC3: of the ground truth, the cloud file/);
  assert.match(out, /1 of 3 models scored again, 0 figures differ/);
  // Names say nothing: the same files are known wherever they lie.
  rmSync(answer);
  const lacking = fit4cad("submit", data, answers, "--set", "made-up", "--to", mine);
  assert.match(lacking.out, /✗ the set made-up has PC3, of which there is no cloud/);
});

test("a submission that is not whole is not written, and says why", async (t) => {
  const { data, answers, results } = await madeUp(t);
  const mine = join(results, "mine");
  const refused = (/** @type {string[]} */ ...paths) => {
    const { code, out } = fit4cad("submit", ...paths, "--set", "made-up", "--to", mine);
    assert.equal(code, 1);
    assert.ok(!existsSync(mine));
    return out;
  };
  assert.match(refused(data), /✗ there are no answers: put them in a folder named after the method/);
  rmSync(join(answers, "pointCloud_primitives_Imperfect/PC2_primitives.txt"));
  assert.match(refused(data, answers), /✗ Imperfect gives no primitives for PC2: every model has to be answered/);
  for (const [args, expected] of /** @type {[string[], RegExp][]} */ ([
    [["--to", mine], /--set : expected made-up, made-up-noise/],
    [["--set", "test-10"], /say which folder is to be written/],
    [["--set", "made-up", "--to", join(results, "No Such")], /small letters, digits and hyphens/],
    [["--set", "made-up", "--to", mine, "--times", answers], /expected a list of/],
  ])) {
    const { code, err } = fit4cad("submit", data, answers, ...args);
    assert.equal(code, 2, err);
    assert.match(err, expected);
  }
});

test("what a fitter of the playground finds is made again by whoever verifies it", async (t) => {
  const { data, results } = await madeUp(t);
  const found = join(results, "../found");
  const { out } = fit4cad("fit", "--method", "ht", "--out", found, "--json", data);
  writeFileSync(join(results, "../times.json"), out);
  const mine = join(results, "mine");
  const submitted = fit4cad("submit", data, found, "--set", "made-up", "--to", mine, "--times", join(results, "../times.json"));
  assert.match(submitted.out, /3 answers of HT, all with surfaces/);
  writeFileSync(join(mine, "method.toml"), methodToml({ answers: '{ called = "HT", licence = "CC0-1.0", fitter = "ht" }' }));
  const verified = fit4cad("verify", mine, "--data", data);
  assert.match(verified.out, /3 of 3 models scored again, every digit the same/);
  const scores = JSON.parse(readFileSync(join(mine, "scores.json"), "utf8"));
  assert.equal(scores.sets[0].summary.seconds.count, 3);
  writeFileSync(join(mine, "method.toml"), methodToml({ answers: '{ called = "HT", licence = "CC0-1.0", fitter = "pg" }' }));
  assert.match(fit4cad("verify", mine, "--data", data).out, /the fitter found something else here/);
});

test("a scores.json that a stranger sent is read key by key", async (t) => {
  const { data, answers, results } = await madeUp(t);
  const mine = join(results, "mine");
  fit4cad("submit", data, answers, "--set", "made-up", "--to", mine);
  const text = readFileSync(join(mine, "scores.json"), "utf8");
  const { sets } = readSets(SETS);
  const { scores, findings } = readScores(text, sets);
  assert.equal(told(findings), "");
  assert.equal(writeScores(scores), text);
  /** @param {(scores: any) => void} change */
  const changed = (change) => {
    const copy = JSON.parse(text);
    change(copy);
    return told(readScores(JSON.stringify(copy), sets).findings);
  };
  assert.match(told(readScores(text.slice(0, 1000), sets).findings), /^file: it is no JSON: .*was it cut off\?$/);
  assert.match(told(readScores("[".repeat(1e6), sets).findings), /^file: it is no JSON/);
  assert.match(told(readScores(" ".repeat(9 * 2 ** 20), sets).findings), /^file: it has more than/);
  assert.match(changed((all) => all.sets[0].models.pop()), /the set has PC3, of which there is nothing here/);
  assert.match(changed((all) => all.sets[0].models.push(all.sets[0].models[0])), /PC1: stands here more than once/);
  assert.match(changed((all) => (all.sets[0].models[0].model = "<img src=x>")), /there is no <img src=x> in the set/);
  assert.match(changed((all) => (all.sets[0].models[0].definition.DSC = "1")), /definition\.DSC: expected a number, found "1"/);
  const huge = (/** @type {string} */ key) => told(readScores(text.replace(new RegExp(`"${key}": ?[-\\d.]+`), `"${key}":1e999`), sets).findings);
  assert.match(huge("DSC"), /definition\.DSC: expected a number, found Infinity/);
  assert.match(huge("mean"), /mean: expected a number, found Infinity/);
  assert.match(huge("epsilon"), /epsilon: expected a number of at least 0 and of at most 1000000, found Infinity/);
  assert.match(changed((all) => (all.sets[0].models[0].inputs.cloud = "../../etc/passwd")), /inputs\.cloud: expected a SHA-256/);
  assert.match(changed((all) => (all.sets[0].set = "other")), /expected made-up, made-up-noise, found "other"/);
  assert.match(changed((all) => (all.sets[0].summary.definition.BEST = null)), /"BEST": there is no such key here/);
  assert.match(changed((all) => all.sets.push(all.sets[0])), /the set made-up stands here twice/);
  assert.match(told(readScores(text.replace('"sets"', '"__proto__": {}, "sets"'), sets).findings), /"__proto__": there is no such key/);

  // What the same engine knows and the claim leaves out is told; what an engine before did not know is not.
  const [set] = scores.sets;
  assert.deepEqual(differencesOf(set, set), []);
  /** @type {any} */
  const less = JSON.parse(JSON.stringify(set));
  delete less.models[0].definition.DSC;
  assert.deepEqual(differencesOf(less, set).map(({ figure, claimed }) => [figure, claimed]), [["definition DSC", undefined]]);
  assert.deepEqual(differencesOf({ ...less, engine: "0.1.0" }, set), []);
});

test("the feed tells what came into the table and what changed, the newest first", () => {
  const { method } = readMethod(methodToml({ changes: '[{ day = 2026-12-01, what = "Answers mended." }]' }));
  const feed = JSON.parse(feedOf([{ id: "mine", method, sets: ["Made up"] }], "https://example.org/page/"));
  assert.equal(feed.version, "https://jsonfeed.org/version/1.1");
  assert.deepEqual(feed.items.map((/** @type {any} */ item) => [item.title, item.date_published, item.url]), [
    ["Mine changed", "2026-12-01T00:00:00Z", "https://example.org/page/?page=results&method=mine"],
    ["Mine is in the table", "2026-11-29T00:00:00Z", "https://example.org/page/?page=results&method=mine"],
  ]);
  assert.equal(new Set(feed.items.map((/** @type {any} */ item) => item.id)).size, 2);
});

test("the same models, options and seed are made worse in the same way", (t) => {
  const root = folder(t, {});
  fit4cad("generate", "bracket", "--spacing", "0.04", "--name", "PC7", "--out", join(root, "data"));
  const [one, two, three] = ["5", "5", "6"].map((seed, at) => {
    const out = join(root, String(at));
    const { code, err } = fit4cad("degrade", join(root, "data"), "--missing", "0.2", "--outliers", "0.1", "--density", "10", "--seed", seed, "--out", out);
    assert.equal(code, 0, err);
    return readFileSync(join(out, "pointCloud/PC7.txt"), "utf8");
  });
  assert.equal(one, two);
  assert.notEqual(one, three);
  const refused = fit4cad("degrade", root).err;
  assert.match(refused, /say what is to be done: --noise N.*--density N/);
  assert.match(fit4cad("degrade", root, "--density", "0.1").err, /--density 0\.1/);
});

test("the paper's rows are verified from the published answers", { skip: WITHOUT_PUBLIC_FILES }, () => {
  const data = join(PUBLIC_FILES, "test_sample");
  const { code, out } = fit4cad("verify", join(RESULTS, "paper-ht"), join(RESULTS, "paper-pg"), "--data", data);
  assert.equal(out.match(/10 of 10 models scored again, every digit the same/g)?.length, 2, out);
  assert.equal(code, 0);
});
