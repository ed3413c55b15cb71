import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { strToU8, zipSync } from "fflate";
import { MEASURES } from "../../www/shared/formats/measures.mjs";
import {
  PUBLIC_FILES,
  WITHOUT_PUBLIC_FILES,
  fit4cad,
  folder,
  submitted,
  twoPlanes,
} from "./support.mjs";

/**
 * @param {string} out
 * @returns {import("../../www/shared/formats/results.mjs").Result[]}
 */
function reportsIn(out) {
  return JSON.parse(out);
}

test("a perfect submission scores one in classification and zero in distance", (t) => {
  const { code, out, err } = fit4cad("score", folder(t, submitted("PC1", "HT")), "--format", "json");
  assert.equal(err, "");
  assert.equal(code, 0);
  const [report, ...others] = reportsIn(out);
  assert.deepEqual(others, []);
  const { model, method, protocol, points, truth, predicted, type_errors: errors } = report;
  assert.deepEqual(
    { model, method, protocol, points, truth, predicted, errors },
    { model: "PC1", method: "HT", protocol: "definition", points: 18, truth: 2, predicted: 2, errors: 0 },
  );
  assert.deepEqual(
    MEASURES.map((measure) => report.mean[measure]),
    [1, 1, 1, 1, 1, 1, 0, 0, 0],
  );
  assert.deepEqual(
    report.primitives.map(({ truth: number, match, type, DSC }) => [number, match, type, DSC]),
    [
      [1, 1, "Plane", 1],
      [2, 2, "Plane", 1],
    ],
  );
  assert.deepEqual(report.diagnostics, []);
});

test("reports are ordered by model number, then method", (t) => {
  const files = { ...submitted("PC10", "PG", "HT"), ...submitted("PC2", "PG", "HT") };
  const { out } = fit4cad("score", folder(t, files), "--format", "json");
  const order = reportsIn(out).map(({ model, method }) => `${model} ${method}`);
  assert.deepEqual(order, ["PC2 HT", "PC2 PG", "PC10 HT", "PC10 PG"]);
});

test("a measure that cannot be had is null", (t) => {
  const files = submitted("PC1", "PG");
  delete files["pointCloud_parametric_PG/PC1_parametric.txt"];
  delete files["pointCloud_implicit_PG/PC1_implicit.txt"];
  const root = folder(t, files);
  const [{ mean, primitives }] = JSON.parse(fit4cad("score", root, "--format", "json").out);
  assert.deepEqual([mean.MFE, mean.dHaus, mean.d1], [null, null, null]);
  assert.equal(primitives[0].MFE, null);
  assert.equal(mean.DSC, 1);
  assert.match(fit4cad("score", root).out, /n\/a/);
});

test("the published protocol exchanges precision and recall", (t) => {
  const files = submitted("PC1", "HT");
  // Half of the second square is missing from its prediction: recall falls, precision does not.
  files["pointCloud_primitives_HT/PC1_primitives.txt"] =
    "Primitive1:=[1 2 3 4 5 6 7 8 9];\nPrimitive2:=[10 11 12];\n";
  const root = folder(t, files);
  /** @param {string} protocol */
  const mean = (protocol) =>
    JSON.parse(fit4cad("score", root, "--format", "json", "--protocol", protocol).out)[0].mean;
  const [definition, published] = [mean("definition"), mean("published")];
  assert.equal(definition.PPV, 1);
  assert.equal(definition.TPR, (1 + 3 / 9) / 2);
  assert.deepEqual([published.PPV, published.TPR], [definition.TPR, definition.PPV]);
});

test("a broken entry is reported on stderr with its place, the rest is scored, the code is 1", (t) => {
  const files = submitted("PC1", "HT");
  files["pointCloud_parametric_HT/PC1_parametric.txt"] =
    "Primitive1:=[Plane, [1 0 0 0 1 0 0 0 0]];\nPrimitive2:=[Plane, [0 0 1 1]];\n";
  const { code, out, err } = fit4cad("score", folder(t, files), "--format", "csv");
  assert.equal(code, 1);
  assert.match(err, /PC1_parametric\.txt:2:\d+: error: .*found 4.*expected 9/);
  assert.equal(out.split("\r\n")[1].split(",")[6], "1");
});

test("JSON holds the diagnostics and stderr stays empty", (t) => {
  const files = submitted("PC1", "HT");
  files["pointCloud_primitives_HT/PC1_primitives.txt"] =
    "Primitive1:=[1 2 3 4 5 6 7 8 9];\nPrimitive2:=[10 11 99];\n";
  const { out, err } = fit4cad("score", folder(t, files), "--format", "json");
  const [{ diagnostics }] = JSON.parse(out);
  assert.equal(diagnostics.length, 1);
  assert.equal(diagnostics[0].line, 2);
  assert.equal(err, "");
});

test("a zip scores like the folder it was made of", (t) => {
  const files = submitted("PC3", "HT", "PG");
  const root = folder(t, files);
  const entries = Object.entries(files).map(([path, text]) => [`Fit4CAD-main/${path}`, strToU8(text)]);
  const litter = { "Fit4CAD-main/.DS_Store": strToU8("x"), "Fit4CAD-main/Icon\r": strToU8("") };
  const zip = join(folder(t, {}), "files.zip");
  writeFileSync(zip, zipSync({ ...Object.fromEntries(entries), ...litter }));
  const [fromFolder, fromZip] = [fit4cad("score", root), fit4cad("score", zip)];
  assert.equal(fromZip.out, fromFolder.out);
  assert.equal(fromZip.code, 0);
});

test("a damaged zip is reported and the other paths are scored", (t) => {
  const root = folder(t, submitted("PC1", "HT"));
  const zip = join(folder(t, {}), "broken.zip");
  writeFileSync(zip, Buffer.from("PK\u0003\u0004 and then nothing"));
  const { code, out, err } = fit4cad("score", zip, root);
  assert.equal(code, 1);
  assert.match(err, /broken\.zip: error: it is no zip, or a damaged one/);
  assert.match(out, /PC1 +HT/);
});

test("a zip entry that is cut off is reported by its name", (t) => {
  const files = submitted("PC1", "HT");
  const entries = Object.entries(files).map(([path, text]) => [path, strToU8(text)]);
  const bytes = zipSync(Object.fromEntries(entries));
  const name = strToU8("pointCloud_primitives_HT/PC1_primitives.txt");
  const at = Buffer.from(bytes).indexOf(Buffer.from(name)) + name.length;
  bytes.fill(0xff, at, at + 8);
  const zip = join(folder(t, {}), "cut.zip");
  writeFileSync(zip, bytes);
  const { code, err } = fit4cad("score", zip);
  assert.equal(code, 1);
  assert.match(err, /pointCloud_primitives_HT\/PC1_primitives\.txt: error: The file could not be read: it cannot be unpacked/);
});

test("the truth scores itself with --self", (t) => {
  const { code, out } = fit4cad("score", folder(t, twoPlanes("PC7")), "--self", "--format", "json");
  assert.equal(code, 0);
  const [{ method, mean }] = JSON.parse(out);
  assert.equal(method, "truth");
  assert.equal(mean.DSC, 1);
});

test("missing submissions, truth and files are said plainly", (t) => {
  /** @param {RegExp} pattern */
  const without = (pattern) =>
    Object.fromEntries(Object.entries(submitted("PC1", "HT")).filter(([path]) => !pattern.test(path)));
  const noSubmission = fit4cad("score", folder(t, without(/_HT\//)));
  assert.equal(noSubmission.code, 1);
  assert.match(noSubmission.err, /PC1: note: there is no submission to score/);
  const noTruth = fit4cad("score", folder(t, without(/(primitives|parametric|implicit)\//)));
  assert.equal(noTruth.code, 1);
  assert.match(noTruth.err, /PC1: error: there is no ground truth/);
  const nothing = fit4cad("score", "no/such/place");
  assert.equal(nothing.code, 1);
  assert.match(nothing.err, /no\/such\/place: error: there is no such file or folder/);
  assert.equal(nothing.out, "");
});

test("a method named like a formula stays a text in CSV", (t) => {
  const { out } = fit4cad("score", folder(t, submitted("PC1", "=1+2")), "--format", "csv");
  const [head, row] = out.split("\r\n");
  assert.equal(head.split(",").length, row.split(",").length);
  assert.equal(row.split(",")[1], "'=1+2");
});

test("LaTeX comes as a booktabs table with special characters escaped", (t) => {
  const { out } = fit4cad("score", folder(t, submitted("PC1", "A&B")), "--format", "latex");
  assert.match(out, /\\toprule[\s\S]*\\midrule[\s\S]*\\bottomrule/);
  assert.match(out, /PC 1 & A\\&B & \$18\$ & \$2\$ & \$2\$ & \$1\.000\$/);
});

test("the golden values of the ten public test models come out", { skip: WITHOUT_PUBLIC_FILES }, () => {
  const golden = JSON.parse(readFileSync(join(PUBLIC_FILES, "golden.json"), "utf8"));
  /** @type {Record<string, number>} */
  const tolerance = { MFE: 1e-7, dHaus: 1e-7 };
  for (const protocol of ["definition", "published"]) {
    const run = fit4cad("score", join(PUBLIC_FILES, "test_sample"), "--format", "json", "--protocol", protocol);
    const reports = JSON.parse(run.out);
    assert.equal(reports.length, 20);
    for (const { model, method, mean, type_errors: errors, points, truth } of reports) {
      const { type_errors: expectedErrors, ...expected } = golden[model][method][protocol];
      assert.deepEqual([points, truth], [golden[model].points, golden[model].truth]);
      for (const [measure, value] of Object.entries(expected)) {
        const difference = Math.abs(mean[measure] - value);
        assert.ok(
          difference <= (tolerance[measure] ?? 1e-9),
          `${protocol} ${model} ${method} ${measure}: ${mean[measure]} for ${value}`,
        );
      }
      if (expectedErrors !== undefined) {
        assert.equal(errors, expectedErrors, `${model} ${method}`);
      }
    }
  }
});
