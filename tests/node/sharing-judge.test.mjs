import assert from "node:assert/strict";
import { test } from "node:test";
import { pageModule } from "./page.mjs";

const { judge } = await pageModule("sharing/judge.ts");

const MEAN = { DSC: 0.9, PPV: 0.8, TPR: 0.7, TNR: 0.6, NPV: 0.5, ACC: 0.4, MFE: 0.3, dHaus: 0.2, d1: null };
const MODEL = { name: "PC1", points: 18, truth: 2, origin: { kind: "files" }, inputs: "1111111111111111" };
const CLAIM = { model: 0, method: "MINE", predicted: 3, typeErrors: 1, submission: "2222222222222222", mean: MEAN };
const CANDIDATE = {
  model: "PC1",
  inputs: MODEL.inputs,
  submission: CLAIM.submission,
  report: { model: "PC1", method: "MINE", points: 18, truth: 2, predicted: 3, type_errors: 1, mean: MEAN },
};

const withMean = (mean) => ({ ...CANDIDATE, report: { ...CANDIDATE.report, mean: { ...MEAN, ...mean } } });

test("the same files with the same figures bear a claim out, whatever they are called", () => {
  assert.deepEqual(judge(CLAIM, MODEL, [CANDIDATE]), { kind: "verified" });
  const renamed = { ...CANDIDATE, model: "copy", report: { ...CANDIDATE.report, method: "copied" } };
  assert.deepEqual(judge(CLAIM, MODEL, [renamed]), { kind: "verified" });
});

test("a figure that differs in its last bit does not pass", () => {
  const next = 0.9 + 2 ** -53;
  assert.notEqual(next, 0.9);
  assert.deepEqual(judge(CLAIM, MODEL, [withMean({ DSC: next })]), {
    kind: "differs",
    differences: [{ figure: "DSC", claimed: 0.9, found: next }],
  });
});

test("every figure that differs is told, also one that is missing on one side and a count", () => {
  const found = withMean({ MFE: null, d1: 0 });
  const { differences } = judge({ ...CLAIM, predicted: 4 }, MODEL, [found]);
  assert.deepEqual(differences, [
    { figure: "predicted", claimed: 4, found: 3 },
    { figure: "MFE", claimed: 0.3, found: null },
    { figure: "d1", claimed: null, found: 0 },
  ]);
});

test("other files under the same names say which files they are", () => {
  const other = "3333333333333333";
  const parts = (change) => judge(CLAIM, MODEL, [{ ...CANDIDATE, ...change }]).parts;
  assert.deepEqual(parts({ inputs: other }), ["ground truth"]);
  assert.deepEqual(parts({ submission: other }), ["submission"]);
  assert.deepEqual(parts({ inputs: other, submission: other }), ["ground truth", "submission"]);
});

test("a claim stays a claim while its files are not there, or where it names none", () => {
  assert.deepEqual(judge(CLAIM, MODEL, []), { kind: "claimed" });
  const { inputs: _, ...unhashed } = MODEL;
  assert.deepEqual(judge(CLAIM, unhashed, [{ ...CANDIDATE, inputs: undefined }]), { kind: "uncheckable" });
});
