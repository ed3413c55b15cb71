import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { test } from "node:test";
import { pageModule } from "./page.mjs";
import { fit4cad, folder, submitted } from "./support.mjs";

const { commandLine } = await pageModule("export/command.ts");
const { pythonLines } = await pageModule("export/python.ts");

/** @param {object} [change] */
const onScreen = (change) => ({ paths: [], samples: [], parts: [], fits: [], corrections: {}, protocol: "definition", ...change });

/**
 * The arguments of each call of `fit4cad` in a line, as a POSIX shell understands it.
 * @param {string} line
 */
function understood(line) {
  const script = `fit4cad() { for word in "$@"; do printf '%s\\0' "$word"; done; printf '\\n\\0'; }\n${line}`;
  const { stdout, stderr } = spawnSync("sh", ["-c", script], { encoding: "utf8" });
  assert.equal(stderr, "");
  /** @type {string[][]} */
  const calls = [[]];
  for (const word of stdout.split("\0").slice(0, -1)) {
    if (word === "\n") calls.push([]);
    else calls.at(-1)?.push(word);
  }
  return calls.slice(0, -1);
}

test("folders and zips are named once, loose files each", () => {
  const paths = ["set/PC1.txt", "set/HT/PC1_primitives.txt", "more.zip/PC2.txt", "PC10.txt", "PC9.txt"];
  assert.equal(commandLine(onScreen({ paths })), "fit4cad score more.zip PC9.txt PC10.txt set");
});

test("the protocol is said where it is not the default", () => {
  const line = commandLine(onScreen({ paths: ["PC1.txt"], protocol: "published" }));
  assert.equal(line, "fit4cad score PC1.txt --protocol published");
});

test("a sample is made first, with what was said about it and nothing else", () => {
  const samples = [
    { name: "flange", part: "flange", options: {} },
    { name: "flange-noise0.001-seed3", part: "flange", options: { noise: 0.001, seed: 3 } },
  ];
  const worn = "flange-noise0.001-seed3";
  assert.deepEqual(understood(commandLine(onScreen({ samples, paths: ["mine/PC1.txt"] }))), [
    ["generate", "flange", "--imperfect", "--out", "flange"],
    ["generate", "flange", "--noise", "0.001", "--seed", "3", "--imperfect", "--name", worn, "--out", worn],
    ["score", "flange", worn, "mine"],
  ]);
});

test("a fit is repeated with its settings on what it was made on, and scored with the rest", () => {
  const samples = ["flange", "gear"].map((part) => ({ name: part, part, options: {} }));
  const fits = [
    { request: { method: "ht", parameters: {}, seed: 1 }, samples: ["gear"], brought: false },
    { request: { method: "pg", parameters: { fuzzy_border: 0.2 }, seed: 9 }, samples: ["flange"], brought: true },
  ];
  assert.deepEqual(understood(commandLine(onScreen({ samples, fits, paths: ["my set/PC1.txt"] }))).slice(2), [
    ["fit", "gear", "--method", "ht", "--seed", "1", "--out", "fits"],
    ["fit", "flange", "my set", "--method", "pg", "--fuzzy-border", "0.2", "--seed", "9", "--out", "fits"],
    ["score", "flange", "gear", "my set", "fits"],
  ]);
});

test("a part from CAD is imported first, as it was on the page, and fitted and scored with the rest", () => {
  const parts = [
    { name: "plate", path: "plate.step", options: {} },
    { name: "arm", path: "my parts/arm.stp.gz", options: { points: 500, spread: "scan", views: 3, separate: true }, bodies: [1, 3] },
    { name: "a", path: "more.zip/a.step", options: {} },
    { name: "b", path: "more.zip/b.step", options: {} },
  ];
  const files = parts.map(({ name, path }) => `${path}/${name}.txt`);
  const fits = [{ request: { method: "ht", parameters: {}, seed: 1 }, samples: [], brought: true }];
  assert.deepEqual(understood(commandLine(onScreen({ parts, fits, paths: [...files, "PC1.txt"] }))), [
    ["import", "plate.step", "--out", "plate"],
    ["import", "my parts/arm.stp.gz", "--points", "500", "--spread", "scan", "--views", "3", "--separate", "--bodies", "1,3", "--out", "arm"],
    ["import", "more.zip", "--out", "more"],
    ["fit", "plate", "arm", "more", "PC1.txt", "--method", "ht", "--seed", "1", "--out", "fits"],
    ["score", "plate", "arm", "more", "PC1.txt", "fits"],
  ]);
});

test("the lines of Python import it as it was, too", () => {
  const parts = [{ name: "arm", path: "arm.step", options: { points: 500, spread: "scan", separate: true }, bodies: [1, 3] }];
  const lines = pythonLines(onScreen({ parts, paths: ["arm.step/arm.txt", "PC1.txt"] })).split("\n");
  assert.ok(lines.includes('brought = list(fit4cad.read_all("PC1.txt"))'), lines.join("\n"));
  assert.ok(lines.includes('brought += fit4cad.read_all("arm.step", points=500, spread="scan", separate=True, bodies=[1, 3])'), lines.join("\n"));
});

test("whatever a folder is called, the shell takes it for one name", () => {
  const names = ["my results", "it's", "$(touch x)", "`x`", "a;b", "a&&b", "*", "~", "#1", "größe", 'say "x"', "a\nb", "back\\slash", "!x"];
  for (const name of names) {
    const line = commandLine(onScreen({ paths: [`${name}/PC1.txt`] }));
    assert.deepEqual(understood(line), [["score", name]], line);
  }
  assert.deepEqual(understood(commandLine(onScreen({ paths: ["--format/PC1.txt"] }))), [["score", "./--format"]]);
});

test("corrections made by hand are in the line, and the command line heeds them", (t) => {
  const { "pointCloud/PC1.txt": cloud, ...files } = submitted("PC1", "HT");
  const root = folder(t, { ...files, "scan, 50% of it.asc": cloud });
  const corrections = {
    [`${root}/scan, 50% of it.asc`]: { role: "cloud", model: "PC1" },
    ...Object.fromEntries(
      ["primitives", "parametric", "implicit"].map((role) => [
        `${root}/pointCloud_${role}_HT/PC1_${role}.txt`,
        { method: "a:b,c" },
      ]),
    ),
  };
  // As if the folder had been dropped from where paths begin.
  const line = commandLine(onScreen({ paths: Object.keys(corrections), corrections }));
  const [[, ...words]] = understood(line);
  const options = words.slice(words.indexOf("--as"));
  const { code, out } = fit4cad("score", root, "--format", "json", ...options);
  /** @type {import("../../bin/engine/engine.js").Report[]} */
  const reports = JSON.parse(out);
  assert.deepEqual(reports.map(({ model, method }) => [model, method]), [["PC1", "a:b,c"]]);
  assert.equal(code, 0);
});

test("a correction that cannot be understood, or of no file, is a wrong call", (t) => {
  const root = folder(t, submitted("PC1", "HT"));
  /** @type {[string, RegExp][]} */
  const values = [
    ["role=cloud", /expected role=…/],
    ["role=sphere:x", /expected cloud, primitives/],
    ["colour=red:x", /before the colon/],
    ["model=100%:x", /%25/],
    ["role=cloud:no such file", /no such file among those given/],
  ];
  for (const [value, expected] of values) {
    const { code, err } = fit4cad("score", root, "--as", value);
    assert.equal(code, 2, value);
    assert.match(err, expected);
  }
});

test("nothing on screen gives no line", () => {
  assert.equal(commandLine(onScreen()), undefined);
});
