import assert from "node:assert/strict";
import { test } from "node:test";
import { FIGURES } from "../../www/generated/declared/figures.js";
import { FIGURE_SCALE } from "../../www/generated/declared/figure-scale.js";
import { fit4cad, folder, submitted } from "./support.mjs";

/**
 * @param {string} out
 * @returns {{ engine: string, results: { model: string, method: string, figures: { figure: string, value: number | null, protocol: string, normalisation: string | null, engine: string }[], primitives: unknown[], files: { sha256: string }[] }[], summaries: { method: string, figures: { figure: string, mean: number, median: number, interval: [number, number] | null }[] }[], comparisons: { figure: string, method: string, against: string, better: number, even: number, worse: number, test: { probability: number } | null }[], strata: { by: string, rows: { stratum: string, primitives: number, iou: { mean: number } }[] }[] }}
 */
const read = (out) => JSON.parse(out);

/** Two models: HT finds all, PG finds the first of two squares and half of the other. */
function twoModels() {
  const files = { ...submitted("PC1", "HT", "PG"), ...submitted("PC2", "HT", "PG") };
  for (const model of ["PC1", "PC2"]) {
    files[`pointCloud_primitives_PG/${model}_primitives.txt`] =
      "Primitive1:=[1 2 3 4 5 6 7 8 9];\nPrimitive2:=[10 11 12];\n";
  }
  return files;
}

test("protocols side by side are what their rules say, in the order of the list", (t) => {
  const { code, out, err } = fit4cad("score", folder(t, twoModels()), "--protocol", "pq,spfn,definition");
  assert.equal(err, "");
  assert.equal(code, 0);
  const [caption, head, ...rows] = out.split("\n");
  assert.equal(caption, "figures");
  assert.match(head, /^model +method +Fit4CAD DSC +SPFN +PQ$/);
  assert.match(rows[0], /^PC1 +HT +1\.0000 +1\.0000 +1\.0000$/);
  // DSC (1 + 6/12)/2, IoU (1 + 3/9)/2, one hit of IoU 1 among two and two primitives.
  assert.match(rows[1], /^PC1 +PG +0\.7500 +0\.6667 +0\.5000$/);
  assert.match(out, /^mean of 2 +PG +0\.7500/m);
  assert.match(out, /^95 % interval from +PG +0\.7500/m);
  assert.match(out, /^median +PG +0\.7500/m);
});

test("JSON says of every figure by which protocol, in which unit and by which engine it is", (t) => {
  const { out } = fit4cad("score", folder(t, twoModels()), "--protocol", "all", "--measures", "all", "--json");
  const { engine, results, summaries, comparisons } = read(out);
  assert.equal(results.length, 4);
  for (const { figures, files } of results) {
    assert.deepEqual(figures.map(({ figure }) => figure), FIGURES.map(({ key }) => key));
    for (const { figure, protocol, normalisation, engine: version } of figures) {
      const info = FIGURES.find(({ key }) => key === figure);
      assert.ok(protocol.length > 0);
      assert.equal(version, engine);
      assert.equal(normalisation, info?.isNormalised ? FIGURE_SCALE.normalisation : null);
    }
    assert.ok(files.every(({ sha256 }) => /^[0-9a-f]{64}$/.test(sha256)));
  }
  const pq = summaries.find(({ method }) => method === "PG")?.figures.find(({ figure }) => figure === "pq");
  assert.deepEqual([pq?.mean, pq?.median, pq?.interval], [0.5, 0.5, [0.5, 0.5]]);
  const pair = comparisons.find(({ figure }) => figure === "spfn");
  assert.deepEqual([pair?.method, pair?.against, pair?.better, pair?.even, pair?.worse], ["HT", "PG", 2, 0, 0]);
  // Two differences of one sign: 2 of 2² ways.
  assert.equal(pair?.test?.probability, 0.5);
});

test("figures of fit are told in the unit that was asked for", (t) => {
  const root = folder(t, twoModels());
  /** @param {string[]} options */
  const head = (...options) => fit4cad("score", root, "--measures", "residual,p-coverage", ...options).out.split("\n")[1];
  assert.match(head(), /P-coverage \(ε = 0\.01 of the unit sphere's radius\) +Residual \(of the unit sphere's radius\)/);
  assert.match(head("--normalisation", "none", "--epsilon", "0.5"), /ε = 0\.5 in the file's units/);
});

test("true primitives are told apart by size and by type", (t) => {
  const { out } = fit4cad("score", folder(t, twoModels()), "--protocol", "spfn", "--by", "size,type", "--json");
  const { strata } = read(out);
  assert.deepEqual(strata.map(({ by }) => by), ["size", "type"]);
  const planes = strata[1].rows.filter(({ stratum }) => stratum === "Plane");
  assert.deepEqual(planes.map(({ primitives, iou }) => [primitives, iou.mean]), [[4, 1], [4, 2 / 3]]);
});

test("every text format holds the figures, and how they came about", (t) => {
  const root = folder(t, twoModels());
  for (const format of ["csv", "latex", "markdown"]) {
    const { code, out } = fit4cad("score", root, "--protocol", "spfn,f1", "--by", "type", "--format", format);
    assert.equal(code, 0, format);
    assert.match(out, /0\.666/, format);
    assert.match(out, /Fit4CAD engine \d+\.\d+\.\d+, lengths normalised by unit-sphere/, format);
  }
});

test("what there is not is refused with what there is", (t) => {
  const root = folder(t, submitted("PC1", "HT"));
  /** @param {string[]} options */
  const refused = (...options) => {
    const { code, err } = fit4cad("score", root, ...options);
    assert.equal(code, 2, options.join(" "));
    return err;
  };
  assert.match(refused("--protocol", "spfn,nonsense"), /nonsense: expected definition, published, fit4cad, spfn/);
  assert.match(refused("--measures", "beauty"), /beauty: expected .*residual/);
  assert.match(refused("--protocol", "spfn", "--by", "colour"), /colour: expected size, type/);
  assert.match(refused("--measures", "all", "--epsilon", "-1"), /-1: expected a number of at least 0/);
  assert.match(refused("--measures", "all", "--normalisation", "mile"), /mile: expected primitive/);
  assert.match(refused("--normalisation", "cloud"), /--measures/);
});

test("the truth scores itself, also by the rule that it fails", (t) => {
  const { out } = fit4cad("score", folder(t, submitted("PC1", "HT")), "--protocol", "all", "--self", "--json");
  const [report] = read(out).results;
  assert.equal(report.method, "truth");
  for (const { figure, value } of report.figures) {
    // Nine points a face: too few for ParseNet and HPNet to look at.
    assert.equal(value, figure === "parsenet" || figure === "hpnet" ? null : 1, figure);
  }
});
