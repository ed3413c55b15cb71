import assert from "node:assert/strict";
import { test } from "node:test";
import { pageModule } from "./page.mjs";

const { judgeAll } = await pageModule("sharing/judge.ts");
const { sameWords } = await pageModule("../worker/same-words.ts");

const MEAN = { DSC: 0.9, PPV: 0.8, TPR: 0.7, TNR: 0.6, NPV: 0.5, ACC: 0.4, MFE: 0.3, dHaus: 0.2, d1: null };
const MODEL = { name: "PC1", points: 18, truth: 2, origin: { kind: "files" }, inputs: "1111111111111111" };
const CLAIM = { model: 0, method: "MINE", predicted: 3, typeErrors: 1, submission: "2222222222222222", mean: MEAN };
const OWN = { truth: { kind: "files" }, submission: { kind: "files" }, copiesTruth: false };
const CANDIDATE = {
  model: "PC1",
  inputs: MODEL.inputs,
  submission: CLAIM.submission,
  basis: OWN,
  report: { model: "PC1", method: "MINE", points: 18, truth: 2, predicted: 3, type_errors: 1, mean: MEAN },
};
const SAMPLE = { kind: "sample", part: "bracket", options: {} };
const PG = { kind: "fit", request: { method: "pg", seed: 1, parameters: {} } };

/**
 * @typedef {object} Loose An object with parts that need not be right.
 * @typedef {import("../../www/app/sharing/judge").JudgedClaim} JudgedClaim
 */

/** @param {Loose} claim @param {Loose} model @param {readonly Loose[]} candidates */
const judge = (claim, model, candidates) => judgeAll([claim], [model], candidates)[0].verdict;
/** @param {Loose} mean */
const withMean = (mean) => ({ ...CANDIDATE, report: { ...CANDIDATE.report, mean: { ...MEAN, ...mean } } });
/** @param {string} model @param {string} method @param {typeof CANDIDATE} candidate */
const called = (model, method, candidate = CANDIDATE) => ({ ...candidate, model, report: { ...candidate.report, model, method } });
/** @param {Loose} basis @param {typeof CANDIDATE} candidate */
const on = (basis, candidate = CANDIDATE) => ({ ...candidate, basis: { ...OWN, ...basis } });
/** @param {readonly Loose[]} claims @param {readonly Loose[]} models @param {readonly Loose[]} candidates */
const kinds = (claims, models, candidates) =>
  judgeAll(claims, models, candidates).map((/** @type {JudgedClaim} */ { verdict }) => verdict.kind);

test("the reader's own files of the same names with the same figures bear a claim out", () => {
  assert.deepEqual(judge(CLAIM, MODEL, [CANDIDATE]), { kind: "verified", basis: OWN });
});

test("a link's names are not verified by files that the reader calls otherwise", () => {
  /** @param {string} model @param {string} method */
  const of = (model, method) => judge(CLAIM, MODEL, [called(model, method)]);
  assert.deepEqual(of("copy", "copied"), { kind: "renamed", basis: OWN, names: { model: "copy", method: "copied" } });
  assert.deepEqual(of("PC1", "HT"), { kind: "renamed", basis: OWN, names: { method: "HT" } });
  assert.deepEqual(of("PC35", "MINE"), { kind: "renamed", basis: OWN, names: { model: "PC35" } });
  // Letters that look alike are others; accents written in two ways are not, and links cut long names.
  assert.equal(judge({ ...CLAIM, method: "НТ" }, MODEL, [called("PC1", "HT")]).kind, "renamed");
  assert.equal(judge({ ...CLAIM, method: "Me\u0301thode" }, MODEL, [called("PC1", "M\u00e9thode")]).kind, "verified");
  assert.equal(judge({ ...CLAIM, method: "x".repeat(200) }, MODEL, [called("PC1", "x".repeat(300))]).kind, "verified");
});

test("folders that tell a model from its namesakes are no part of its name", () => {
  assert.deepEqual(judge(CLAIM, MODEL, [called("theirs/PC1", "MINE")]), { kind: "verified", basis: OWN, folder: "theirs/" });
  // But a link that names the folder says more than the files do.
  assert.equal(judge(CLAIM, { ...MODEL, name: "test_set/PC1" }, [CANDIDATE]).kind, "renamed");
  assert.equal(judge(CLAIM, { ...MODEL, name: "C1" }, [CANDIDATE]).kind, "renamed");
  assert.equal(judge(CLAIM, { ...MODEL, name: "" }, [called("theirs/", "MINE")]).kind, "renamed");
});

test("of files that the reader has under two names, the claimed one counts, whatever comes first", () => {
  const both = [called("copy", "MINE"), CANDIDATE];
  assert.equal(judge(CLAIM, MODEL, both).kind, "verified");
  assert.equal(judge(CLAIM, MODEL, both.reverse()).kind, "verified");
});

test("what the link itself said how to have is recomputed, never verified, whatever it is called", () => {
  const weak = [
    { truth: SAMPLE, submission: { kind: "imperfect" } },
    { truth: SAMPLE, submission: PG },
    { submission: PG },
    { truth: SAMPLE },
    { truth: { kind: "case" } },
    { truth: { kind: "public", model: { set: "test", number: 1 } }, submission: PG },
    { truth: { kind: "address", address: "https://example.org/a.zip" } },
    { submission: { kind: "address", address: "https://example.org/a.zip" } },
  ];
  for (const basis of weak) {
    assert.deepEqual(judge(CLAIM, MODEL, [on(basis)]), { kind: "recomputed", basis: { ...OWN, ...basis }, names: {} });
    assert.equal(judge(CLAIM, MODEL, [called("bracket", "PG", on(basis))]).kind, "recomputed");
  }
});

test("what the public repository itself holds is as good as the reader's files", () => {
  const model = { kind: "public", model: { set: "test", number: 1 } };
  for (const basis of [{ truth: model, submission: model }, { truth: model }]) assert.equal(judge(CLAIM, MODEL, [on(basis)]).kind, "verified");
  // The link calls PC35 of the test set PC1.
  const other = { kind: "public", model: { set: "test", number: 35 } };
  assert.deepEqual(judge(CLAIM, MODEL, [called("PC35", "MINE", on({ truth: other }))]).names, { model: "PC35" });
});

test("the reader's own files outdo the same ones made again", () => {
  const candidates = [on({ truth: SAMPLE, submission: PG }), CANDIDATE];
  assert.equal(judge(CLAIM, MODEL, candidates).kind, "verified");
  assert.equal(judge(CLAIM, MODEL, candidates.reverse()).kind, "verified");
});

test("a submission that is the ground truth itself is told from a good one", () => {
  assert.equal(judge(CLAIM, MODEL, [on({ copiesTruth: true })]).kind, "copied");
});

test("a list is the same with other blanks and marks, another with other numbers", () => {
  const list = "Primitive1:=[1 2 3];\nPrimitive2:=[4 5];\n";
  for (const same of ["Primitive1 := [ 1,2 03 ]\n\nPrimitive2:[4   5.0];", list.trimEnd(), `${list} \r\n`]) assert.ok(sameWords(list, same), same);
  for (const other of ["", list.slice(0, 20), `${list}6`, list.replace("4 5", "45"), list.replace("5", "6"), "Primitive1:=[4 5];\nPrimitive2:=[1 2 3];\n"]) {
    assert.ok(!sameWords(list, other), other);
    assert.ok(!sameWords(other, list), other);
  }
});

test("files that the page cannot tell the origin of bear nothing out", () => {
  const unknown = { kind: "unknown" };
  for (const basis of [{ truth: unknown }, { submission: unknown }]) assert.equal(judge(CLAIM, MODEL, [on(basis)]).kind, "recomputed");
});

test("thirty-five names for one model and one submission are one result", () => {
  const models = Array.from({ length: 35 }, (_, i) => ({ ...MODEL, name: `PC${i + 1}` }));
  const claims = models.map((_, model) => ({ ...CLAIM, model, method: "MyNet (ours)" }));
  const made = called("bracket", "PG", on({ truth: SAMPLE, submission: PG }));
  assert.deepEqual(kinds(claims, models, [made]), ["recomputed", ...Array(34).fill("repeated")]);
  const [, second] = judgeAll(claims, models, [made]);
  assert.deepEqual(second.verdict.earlier, { model: "PC1", method: "MyNet (ours)" });
  // Also where the reader has the files.
  assert.deepEqual(kinds(claims, models, [called("PC2", "MyNet (ours)")]).slice(0, 3), ["renamed", "verified", "repeated"]);
});

test("a row that stands twice counts once", () => {
  const twice = [CLAIM, CLAIM, { ...CLAIM, method: "TWIN" }, { ...CLAIM, method: "TWIN" }];
  assert.deepEqual(kinds(twice, [MODEL], [CANDIDATE]), ["verified", "repeated", "repeated", "repeated"]);
  // The reader does have the files twice; each name still counts once.
  assert.deepEqual(kinds(twice, [MODEL], [CANDIDATE, called("PC1", "TWIN")]), ["verified", "repeated", "verified", "repeated"]);
  // A model that is listed twice is the same model.
  assert.deepEqual(kinds([CLAIM, { ...CLAIM, model: 1 }], [MODEL, MODEL], [CANDIDATE]), ["verified", "repeated"]);
});

test("a wrong figure is told also in a row that repeats another", () => {
  const lie = { ...CLAIM, mean: { ...MEAN, DSC: 1 } };
  assert.deepEqual(kinds([CLAIM, lie], [MODEL], [CANDIDATE]), ["verified", "differs"]);
  assert.deepEqual(kinds([lie, CLAIM], [MODEL], [CANDIDATE]), ["differs", "verified"]);
});

test("truth and prediction do not stand for each other", () => {
  const [truth, submission] = [CANDIDATE.inputs, CANDIDATE.submission];
  const swapped = judge({ ...CLAIM, submission: truth }, { ...MODEL, inputs: submission }, [CANDIDATE]);
  assert.deepEqual(swapped, { kind: "other files", parts: ["ground truth", "submission"] });
});

test("a figure that differs in its last bit does not pass, nor one that only reads the same", () => {
  const next = 0.9 + 2 ** -53;
  assert.notEqual(next, 0.9);
  assert.deepEqual(judge(CLAIM, MODEL, [withMean({ DSC: next })]), {
    kind: "differs",
    differences: [{ figure: "DSC", claimed: 0.9, found: next }],
    basis: OWN,
  });
  const rounded = { ...CLAIM, mean: { ...MEAN, DSC: 1 } };
  assert.equal(judge(rounded, MODEL, [withMean({ DSC: 0.99999 })]).kind, "differs");
  assert.equal(judge({ ...CLAIM, mean: { ...MEAN, MFE: -0 } }, MODEL, [withMean({ MFE: 0 })]).kind, "differs");
});

test("a claim with fewer figures than there are does not pass", () => {
  const none = Object.fromEntries(Object.keys(MEAN).map((measure) => [measure, null]));
  const { kind, differences } = judge({ ...CLAIM, mean: none }, MODEL, [CANDIDATE]);
  assert.equal(kind, "differs");
  assert.equal(differences.length, 8);
});

test("every figure that differs is told, also one that is missing on one side and a count", () => {
  const found = withMean({ MFE: null, d1: 0 });
  const { differences } = judge({ ...CLAIM, predicted: 4 }, MODEL, [found]);
  assert.deepEqual(differences, [
    { figure: "predicted", claimed: 4, found: 3 },
    { figure: "MFE", claimed: 0.3, found: null },
    { figure: "d1", claimed: null, found: 0 },
  ]);
  const counts = judge(CLAIM, { ...MODEL, points: 17, truth: 3 }, [CANDIDATE]).differences;
  assert.deepEqual(counts.map((/** @type {{ figure: string }} */ { figure }) => figure), ["points", "truth"]);
});

test("other files under the same names say which files they are", () => {
  const other = "3333333333333333";
  /** @param {Loose} change */
  const parts = (change) => judge(CLAIM, MODEL, [{ ...CANDIDATE, ...change }]).parts;
  assert.deepEqual(parts({ inputs: other }), ["ground truth"]);
  assert.deepEqual(parts({ submission: other }), ["submission"]);
  assert.deepEqual(parts({ inputs: other, submission: other }), ["ground truth", "submission"]);
  // The truth of one candidate and the submission of another make no match.
  const split = [{ ...CANDIDATE, submission: other }, { ...CANDIDATE, inputs: other }];
  assert.equal(judge(CLAIM, MODEL, split).kind, "other files");
});

test("a claim stays a claim while its files are not there, or where none can be told", () => {
  assert.deepEqual(judge(CLAIM, MODEL, []), { kind: "claimed" });
  const { inputs: _, ...unhashed } = MODEL;
  const nameless = { ...CANDIDATE, inputs: undefined, submission: undefined };
  assert.deepEqual(judge(CLAIM, unhashed, [nameless]), { kind: "uncheckable", where: "link" });
  // Where the page cannot hash, its files are not known to be others.
  assert.deepEqual(judge(CLAIM, MODEL, [nameless]), { kind: "uncheckable", where: "page" });
  // Nor does a link gain anything by claiming what an unhashed file would have.
  const forged = { ...MODEL, inputs: "undefined" };
  assert.equal(judge({ ...CLAIM, submission: "undefined" }, forged, [nameless]).kind, "uncheckable");
});

test("no rows are no verification", () => {
  assert.deepEqual(judgeAll([], [MODEL], [CANDIDATE]), []);
});
