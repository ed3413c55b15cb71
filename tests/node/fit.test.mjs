import assert from "node:assert/strict";
import { existsSync, readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { zipSync } from "fflate";
import { fit4cad, folder, twoPlanes } from "./support.mjs";

/** A plate of 20 × 20 points at the height of a fifth of its side, as a cloud alone. */
function plate() {
  const steps = Array.from({ length: 20 }, (_, step) => step);
  const points = steps.flatMap((x) => steps.map((y) => `[${x}, ${y}, 4]`));
  return `Points:=[\n${points.join(", \n")} \n ];\n`;
}

/**
 * @typedef {import("../../bin/cli/fitting.mjs").Fitted} Fitted
 * @param {string[]} args
 * @returns {Fitted[]}
 */
const fitJson = (...args) => {
  const { code, out, err } = fit4cad("fit", "--json", ...args);
  assert.deepEqual([code, err], [0, ""]);
  return JSON.parse(out);
};

/**
 * What does not depend on the clock.
 * @param {readonly Fitted[]} models
 */
const timeless = (models) => models.map(({ seconds, ...rest }) => rest);

for (const method of ["ht", "pg"]) {
  test(`a generated part fitted by ${method} is written where score finds it and scores well`, (t) => {
    const root = folder(t, {});
    const [demo, found] = [join(root, "demo"), join(root, "found")];
    fit4cad("generate", "flange", "--spacing", "0.012", "--out", demo);
    // As it is written everywhere else.
    const NAME = method.toUpperCase();
    const { code, out, err } = fit4cad("fit", "--method", NAME, "--out", found, demo);
    assert.deepEqual([code, err], [0, ""]);
    assert.match(out, /^model +points +seconds +primitives/);
    for (const role of ["primitives", "parametric", "implicit"]) {
      assert.ok(existsSync(join(found, `pointCloud_${role}_${NAME}`, `flange_${role}.txt`)));
    }
    const scored = fit4cad("score", demo, found, "--format", "json");
    assert.deepEqual([scored.code, scored.err], [0, ""]);
    const [report, ...others] = JSON.parse(scored.out);
    assert.deepEqual([report.model, report.method, others.length], ["flange", NAME, 0]);
    assert.ok(report.mean.DSC > 0.9, String(report.mean.DSC));
  });
}

test("a cloud alone is fitted, and its JSON tells points, type and fit of each primitive", (t) => {
  const root = folder(t, { "PC1.txt": plate() });
  const [model, ...others] = fitJson("--method", "ht", root);
  assert.deepEqual(Object.keys(model), ["engine", "model", "points", "seconds", "noise", "primitives", "types"]);
  assert.deepEqual([model.model, model.points, others.length], ["PC1", 400, 0]);
  assert.ok(model.seconds > 0);
  assert.deepEqual(model.primitives.map(({ type, points }) => ({ type, points })), [{ type: "Plane", points: 400 }]);
  assert.ok((model.primitives[0].mfe ?? NaN) < 1e-9);
  assert.equal(model.primitives[0].surface?.type, "Plane");
  assert.ok((model.primitives[0].standardErrors.axis ?? NaN) < 1e-9);
  assert.equal(model.primitives[0].standardErrors.radius, null);
});

test("the noise that is given replaces what is measured, and either is told", (t) => {
  const root = folder(t, {});
  fit4cad("generate", "flange", "--spacing", "0.02", "--noise", "0.002", "--out", root);
  const [measured] = fitJson("--method", "ht", root);
  assert.deepEqual([measured.noise.source, measured.noise.kind], ["measured", "scattered"]);
  const [given] = fitJson("--method", "ht", "--noise", String(2 * measured.noise.deviation), root);
  assert.deepEqual(given.noise, { deviation: 2 * measured.noise.deviation, source: "given", kind: null, step: 0 });
  assert.notDeepEqual(given.primitives, measured.primitives);
  const cylinder = measured.primitives.find(({ type }) => type === "Cylinder");
  assert.ok((cylinder?.standardErrors.radius ?? NaN) < measured.noise.deviation);
});

test("noise that cannot be is told of, and other clouds are fitted all the same", (t) => {
  const wide = plate().replaceAll("19", "1900");
  const root = folder(t, { "PC1.txt": plate(), "PC2.txt": wide });
  const { code, out, err } = fit4cad("fit", "--method", "ht", "--noise", "40", "--json", root);
  assert.equal(code, 1);
  assert.match(err, /PC1.*`noise` is 40, and the cloud no more than 26\.\d+ from corner to corner/);
  assert.deepEqual(JSON.parse(out).map((/** @type {{ model: string }} */ { model }) => model), ["PC2"]);
  for (const bad of ["-1", "NaN", "wide"]) {
    assert.equal(fit4cad("fit", "--method", "ht", "--noise", bad, root).code, 2);
  }
});

test("files, folders and zips are fitted in the order of the models, each once", (t) => {
  const root = folder(t, { "clouds/PC10.txt": plate(), "PC2.txt": plate() });
  const bytes = zipSync({ "PC9.txt": new TextEncoder().encode(plate()) });
  const zipped = folder(t, { "more.zip": bytes });
  const models = fitJson("--method", "pg", root, join(root, "PC2.txt"), join(zipped, "more.zip"));
  assert.deepEqual(models.map(({ model }) => model), ["PC2", "PC9", "PC10"]);
});

test("a seed gives the same primitives again", (t) => {
  const root = folder(t, {});
  fit4cad("generate", "bracket", "--spacing", "0.02", "--noise", "0.001", "--out", root);
  const run = () => timeless(fitJson("--method", "ht", "--seed", "7", root));
  assert.deepEqual(run(), run());
});

test("parameters reach the fitter", (t) => {
  const root = folder(t, { "PC1.txt": plate() });
  /** @param {string[]} args */
  const count = (...args) => fitJson("--method", "pg", ...args, root)[0].primitives.length;
  assert.equal(count("--smallest", "400"), 1);
  assert.equal(count("--smallest", "401"), 0);
});

test("help lists each parameter with range, unit and default", () => {
  const { code, out } = fit4cad("fit", "--help");
  assert.equal(code, 0);
  assert.match(out, /--tolerance N +0 to 0\.05 of the diagonal, default 0/);
  assert.match(out, /--smallest N +whole number, \d+ to \d+ points, default \d+/);
  assert.match(out, /--persistence N .*HT only/);
  assert.match(out, /--sharp-quantile N .*PG only/);
});

test("a wrong call exits with 2 and states what is allowed", (t) => {
  const root = folder(t, { "PC1.txt": plate() });
  /** @type {[string[], RegExp][]} */
  const calls = [
    [[root], /--method ht or --method pg/],
    [["--method", "ransac", root], /expected ht, pg/],
    [["--method", "ht"], /at least one file/],
    [["--method", "ht", "--tolerance", "0.06", root], /--tolerance 0\.06: expected a number from 0 to 0\.05/],
    [["--method", "ht", "--smallest", "5.5", root], /expected a whole number from \d+ to \d+/],
    [["--method", "ht", "--tolerance", "thin", root], /--tolerance thin/],
    [["--method", "pg", "--persistence", "0.2", root], /--persistence is of method ht/],
    [["--method", "ht", "--seed", "-1", root], /--seed -1/],
    [["--method", "ht", "--tolerence", "0", root], /--tolerence/],
  ];
  for (const [args, expected] of calls) {
    const { code, out, err } = fit4cad("fit", ...args);
    assert.deepEqual([code, out], [2, ""], args.join(" "));
    assert.match(err, expected);
  }
});

test("what cannot be fitted is told, the rest is fitted, and the exit code is 1", (t) => {
  const files = { "PC1.txt": plate(), "PC2.txt": "Points:=[ nothing ];\n", "PC3_primitives.txt": "Primitive1:=[1 2];\n" };
  const { code, out, err } = fit4cad("fit", "--method", "ht", "--json", folder(t, files));
  assert.equal(code, 1);
  /** @type {Fitted[]} */
  const models = JSON.parse(out);
  assert.deepEqual(models.map(({ model }) => model), ["PC1"]);
  assert.match(err, /PC2\.txt:1/);
  assert.match(err, /PC3_primitives\.txt: warning: there is no cloud/);
  const nothing = fit4cad("fit", "--method", "ht", folder(t, {}));
  assert.deepEqual([nothing.code, nothing.out], [1, ""]);
});

test("results that cannot be written end the command with a word and exit code 1", (t) => {
  const root = folder(t, { "PC1.txt": plate(), taken: "a file" });
  const { code, err } = fit4cad("fit", "--method", "ht", "--out", join(root, "taken"), join(root, "PC1.txt"));
  assert.equal(code, 1);
  assert.match(err, /could not be written/);
});

test("truth and submissions beside a cloud do not change what is fitted", (t) => {
  const alone = folder(t, { "PC1.txt": plate() });
  const { "PC1_primitives.txt": truth } = twoPlanes("PC1");
  const among = folder(t, { "PC1.txt": plate(), "PC1_primitives.txt": truth, "HT/PC1_primitives.txt": truth });
  /** @param {string} root */
  const fitted = (root) => timeless(fitJson("--method", "ht", root));
  assert.deepEqual(fitted(among), fitted(alone));
  const out = folder(t, {});
  fit4cad("fit", "--method", "ht", "--out", out, among);
  assert.deepEqual(readdirSync(out).sort(), ["pointCloud_implicit_HT", "pointCloud_parametric_HT", "pointCloud_primitives_HT"]);
  assert.match(readFileSync(join(out, "pointCloud_primitives_HT/PC1_primitives.txt"), "utf8"), /^Primitive1:=\[1 2 3/);
});
