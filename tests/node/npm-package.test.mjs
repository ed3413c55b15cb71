// The npm package, packed, and installed into an empty folder without a network: command, module, types, bundle.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { npm, pack } from "../../scripts/lib/pack.mjs";
import { npmCommand } from "../../scripts/lib/paths.mjs";
import { fit4cad } from "./support.mjs";

const ROOT = mkdtempSync(join(tmpdir(), "fit4cad-npm-"));
const EMPTY = join(ROOT, "empty");

before(async () => {
  mkdirSync(EMPTY);
  writeFileSync(join(EMPTY, "package.json"), '{ "name": "elsewhere", "private": true, "type": "module" }\n');
  const tarball = await pack(ROOT);
  await npm(["install", "--offline", "--no-audit", "--no-fund", "--silent", tarball], EMPTY);
});

after(() => rmSync(ROOT, { recursive: true, force: true }));

/**
 * Runs Node in the folder that has the package.
 * @param {string[]} args
 */
function node(...args) {
  const { status, stdout, stderr } = spawnSync(process.execPath, args, { cwd: EMPTY, encoding: "utf8", maxBuffer: 1 << 28 });
  assert.equal(status, 0, stderr);
  return stdout;
}

test("npx runs the command from the package, with the figures of the checkout", async () => {
  await npm(["exec", "--offline", "--", "fit4cad", "generate", "flange", "--out", "demo", "--imperfect"], EMPTY);
  const own = node("node_modules/fit4cad/bin/fit4cad.mjs", "score", "demo", "--json");
  const { out } = fit4cad("score", join(EMPTY, "demo"), "--json");
  const figures = (/** @type {string} */ text) => JSON.parse(text).map((/** @type {{ files: unknown }} */ { files: _, ...report }) => report);
  assert.deepEqual(figures(own), figures(out));
  node("node_modules/fit4cad/bin/fit4cad.mjs", "export", "demo", "--to", "step,ply", "--out", "made");
  assert.match(node("node_modules/fit4cad/bin/fit4cad.mjs", "import", "made", "--points", "500", "--out", "part"), /flange/);
});

const USE = `
import init, { Model, declarations, group } from "fit4cad";
import initCad, { importOptions } from "fit4cad/cad";
await Promise.all([init(), initCad()]);
const model = Model.generate("bracket", { spacing: 0.02 });
const method = model.fit("pg", {}, 1, (stage, share) => void [stage.length, share]);
const report = model.score(method, "definition");
const { models } = group(["PC1.txt", "PC1_primitives.txt"]);
console.log(JSON.stringify([method, report.mean.DSC, models.length, declarations().fitters.length, importOptions().length]));
model.free();
`;

test("Node imports it", () => {
  writeFileSync(join(EMPTY, "use.mjs"), USE);
  const [method, dsc, models, fitters, options] = JSON.parse(node("use.mjs"));
  assert.deepEqual([method, models, fitters], ["PG", 1, 2]);
  assert.ok(dsc > 0.9 && options > 3);
});

test("TypeScript knows its types, and what is none of them", () => {
  writeFileSync(join(EMPTY, "use.ts"), USE);
  writeFileSync(join(EMPTY, "misuse.ts"), 'import { Model } from "fit4cad";\nModel.generate("bracket", { spacing: "wide" });\n');
  const check = (/** @type {string} */ file) =>
    spawnSync(
      process.execPath,
      [
        npmCommand("typescript/bin/tsc"),
        ...["--noEmit", "--strict", "--target", "ES2022", "--module", "NodeNext", "--lib", "ES2023,DOM,ESNext.Disposable", file],
      ],
      { cwd: EMPTY, encoding: "utf8" },
    );
  const right = check("use.ts");
  assert.equal(right.status, 0, right.stdout);
  const wrong = check("misuse.ts");
  assert.match(wrong.stdout, /misuse\.ts\(2,\d+\): error TS2322/);
});

test("a bundler takes the wasm along", () => {
  writeFileSync(join(EMPTY, "index.html"), '<script type="module" src="./use.mjs"></script>\n');
  node(npmCommand("vite/bin/vite.js"), "build", "--logLevel", "warn");
  const assets = readdirSync(join(EMPTY, "dist/assets"));
  const wasm = assets.filter((name) => /^engine_bg.*\.wasm$/.test(name));
  assert.equal(wasm.length, 1, String(assets));
  const bytes = readFileSync(join(EMPTY, "dist/assets", wasm[0]));
  assert.deepEqual(bytes, readFileSync(join(EMPTY, "node_modules/fit4cad/bin/engine/engine_bg.wasm")));
});

test("it carries nothing of the page, and says under which terms it is", () => {
  const { license, version, bundleDependencies } = JSON.parse(readFileSync(join(EMPTY, "node_modules/fit4cad/package.json"), "utf8"));
  assert.equal(license, "MIT OR Apache-2.0");
  assert.match(version, /^\d+\.\d+\.\d+$/);
  assert.deepEqual(bundleDependencies, ["fflate"]);
  assert.deepEqual(readdirSync(join(EMPTY, "node_modules/fit4cad/www")).sort(), ["generated", "shared"]);
});
