import assert from "node:assert/strict";
import { join } from "node:path";
import { test } from "node:test";
import { FIGURES } from "../../www/generated/declared/figures.js";
import { FIGURE_SCALE } from "../../www/generated/declared/figure-scale.js";
import { fit4cad, folder, submitted } from "./support.mjs";

/**
 * @param {string} out
 * @returns {{ engine: string, results: { model: string, method: string, figures: { figure: string, value: number | null, protocol: string, normalisation: string | null, engine: string }[], primitives: unknown[], conditions?: { by: string, value: number | null, stratum: string, declared: boolean }[], files: { sha256: string }[] }[], summaries: { method: string, figures: { figure: string, mean: number, median: number, interval: [number, number] | null, place: number | null }[] }[], comparisons: { figure: string, method: string, against: string, better: number, even: number, worse: number, test: { probability: number } | null }[], strata: { by: string, how: string, rows: { stratum: string, method: string, models: number, primitives: number, protocol: string, engine: string, iou: { mean: number } }[], figures: { stratum: string, method: string, models: number, figures: { figure: string, protocol: string, engine: string, mean: number }[] }[] }[], recognition?: { by: string | null, rows: { stratum: string, method: string, segments: number, protocol: string, normalisation: string, engine: string, rates: Record<string, number | null>, mfe: { mean: number, median: number } | null, parameters: { count: number, median: number } | null }[] }[] }}
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

test("models are told apart by the conditions that are measured on them", (t) => {
  const made = folder(t, {});
  const noises = [0, 0.001, 0.003];
  for (const [at, noise] of noises.entries()) {
    const out = join(made, `set${at}`);
    const { code, err } = fit4cad("generate", "flange", "--name", `PC${at + 1}`, "--noise", String(noise), "--imperfect", "--out", out);
    assert.equal(code, 0, err);
  }
  const { out, err } = fit4cad("score", made, "--protocol", "spfn,pq", "--by", "noise,density,missing", "--json");
  const { results, strata } = read(out);
  assert.equal(err, "");
  const noise = results.map(({ conditions }) => conditions?.find(({ by }) => by === "noise"));
  assert.ok(noise.every((each) => each?.declared === false));
  assert.ok(Number(noise[0]?.value) < 1e-6);
  for (const at of [1, 2]) {
    const ratio = Number(noise[at]?.value) / Number(noises[at]);
    assert.ok(Math.abs(ratio - 1) < 0.1, `${ratio}`);
  }
  assert.deepEqual(strata.map(({ by }) => by), ["noise", "density", "missing"]);
  assert.match(strata[0]?.how ?? "", /^Measured/);
  assert.deepEqual(strata[0]?.rows.map(({ stratum, models }) => [stratum, models]), [
    ["noise < 0.001 % of the diagonal", 1],
    ["0.03 – 0.15 %", 1],
    ["0.15 – 0.75 %", 1],
  ]);
  // One spacing for all, and nothing is missing.
  assert.deepEqual(strata.slice(1).map(({ rows }) => rows.map(({ models }) => models)), [[3], [3]]);
  assert.equal(strata[2]?.rows[0]?.stratum, "missing < 2 %");
  for (const { rows, figures } of strata) {
    assert.ok(rows.every(({ protocol, engine }) => protocol !== "" && engine !== ""));
    assert.ok(figures.every(({ figures: own }) => own.every(({ protocol, engine }) => protocol !== "" && engine !== "")));
    assert.deepEqual(figures[0]?.figures.map(({ figure }) => figure), ["spfn", "pq"]);
  }
  const table = fit4cad("score", made, "--protocol", "spfn", "--by", "noise").out;
  assert.match(table, /true primitives by noise[\s\S]*figures by noise, mean over models/);
});

test("what a manifest declares of a set is not measured", (t) => {
  const manifest = { degradation: { noise: 0.01, missing: 0.2, outliers: 0 }, models: [{ model: "PC1" }] };
  const root = folder(t, { ...twoModels(), "manifest.json": JSON.stringify(manifest) });
  const { out } = fit4cad("score", root, "--protocol", "spfn", "--by", "noise,density,missing", "--json");
  const { results } = read(out);
  const told = (/** @type {string} */ model) =>
    results.find((result) => result.model === model)?.conditions?.map(({ by, value, declared }) => [by, declared, declared ? value : null]);
  assert.deepEqual(told("PC1"), [["noise", true, 0.01], ["density", false, null], ["missing", true, 0.2]]);
  assert.deepEqual(told("PC2"), [["noise", false, null], ["density", false, null], ["missing", false, null]]);
});

test("segments are told by type and measured, as SHREC 2022 has it", (t) => {
  const files = submitted("PC1", "HT", "WRONG");
  // A cylinder of radius 1 in the place of the first square.
  files["pointCloud_parametric_WRONG/PC1_parametric.txt"] =
    "Primitive1:=[Cylinder, [1 0 0 0 1 0 0 0 1 0 0 0]];\nPrimitive2:=[Plane, [1 0 0 0 1 0 0 0 1]];\n";
  delete files["pointCloud_implicit_WRONG/PC1_implicit.txt"];
  const root = folder(t, files);
  const options = ["--protocol", "shrec2022", "--normalisation", "none", "--by", "type"];
  const { out } = fit4cad("score", root, ...options, "--json");
  const { recognition = [], engine } = read(out);
  assert.deepEqual(recognition.map(({ by }) => by), [null, "type"]);
  const [right, wrong] = recognition[0]?.rows ?? [];
  assert.deepEqual(right.rates, { PPV: 1, NPV: null, TPR: 1, TNR: null, ACC: 1 });
  assert.deepEqual([right.mfe?.mean, right.parameters?.median], [0, 0]);
  // Of two planes one is taken for a cylinder: PPV (1 + 0)/2, TPR of planes alone, ACC ½ of both types.
  assert.deepEqual(wrong.rates, { PPV: 0.5, NPV: 0.5, TPR: 0.5, TNR: 0.5, ACC: 0.5 });
  assert.equal(wrong.parameters?.count, 1);
  for (const { protocol, normalisation, engine: version } of recognition.flatMap(({ rows }) => rows)) {
    assert.deepEqual([protocol, normalisation, version], ["SHREC 2022", "none", engine]);
  }
  for (const format of ["table", "csv", "latex", "markdown"]) {
    const text = fit4cad("score", root, ...options, "--format", format).out;
    assert.match(text, /PPV.*NPV.*TPR.*TNR.*ACC/, format);
    assert.match(text, /directed Hausdorff .{1,2}in the file's units/, format);
    assert.match(text, /median/, format);
  }
});

test("places of methods are told, and where a protocol moves them", (t) => {
  const files = submitted("PC1", "WHOLE", "ONE");
  // WHOLE finds both squares as one, ONE finds the first alone.
  const all = Array.from({ length: 18 }, (_, at) => at + 1).join(" ");
  files["pointCloud_primitives_WHOLE/PC1_primitives.txt"] = `Primitive1:=[${all}];\n`;
  files["pointCloud_primitives_ONE/PC1_primitives.txt"] = "Primitive1:=[1 2 3 4 5 6 7 8 9];\n";
  const root = folder(t, files);
  const { out } = fit4cad("score", root, "--protocol", "fit4cad,spfn,pq");
  assert.match(out, /places of the methods/);
  assert.match(out, /^ONE +2 +1 \(up 1\) +1 \(up 1\)$/m);
  assert.match(out, /^WHOLE +1 +2 \(down 1\) +2 \(down 1\)$/m);
  const { summaries } = read(fit4cad("score", root, "--protocol", "fit4cad,spfn,pq", "--json").out);
  const places = Object.fromEntries(summaries.map(({ method, figures }) => [method, figures.map(({ place }) => place)]));
  assert.deepEqual(places, { ONE: [2, 1, 1], WHOLE: [1, 2, 2] });
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
  assert.match(refused("--protocol", "spfn", "--by", "colour"), /colour: expected size, type, noise, density, missing/);
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
