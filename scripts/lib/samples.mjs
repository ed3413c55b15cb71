// Inputs of the benchmark: the public files where they are at hand, else generated parts.

import { existsSync, readFileSync, readdirSync } from "node:fs";
import { join, relative } from "node:path";
import { strToU8, zipSync } from "fflate";
import { benchmarkFiles } from "./paths.mjs";

/** The folder `test_sample` of the public files as the bytes of a zip, or undefined. */
export function testSampleZip() {
  const folder = publicFile("test_sample");
  if (!folder) {
    return undefined;
  }
  const files = readdirSync(folder, { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile())
    .map((entry) => join(entry.parentPath, entry.name));
  return zipSync(
    Object.fromEntries(files.map((path) => [relative(folder, path), readFileSync(path)])),
  );
}

/** The bytes of `training_set.zip`, or undefined. */
export function trainingZip() {
  const path = publicFile("training_set.zip");
  return path && readFileSync(path);
}

/** Every part of the generator, with its truth, as the bytes of a zip. */
export function generatedZip(engine, options = {}) {
  const files = {};
  for (const { name: part } of engine.parts()) {
    const model = engine.Model.generate(part, options);
    const { name } = model.info();
    const texts = model.write();
    model.free();
    files[`${name}.txt`] = strToU8(texts.cloud);
    for (const role of ["primitives", "parametric", "implicit"]) {
      files[`${name}_${role}.txt`] = strToU8(texts[role]);
    }
  }
  return zipSync(files);
}

function publicFile(name) {
  const folder = benchmarkFiles();
  const path = folder && join(folder, name);
  return path && existsSync(path) ? path : undefined;
}
