// What a visitor has to download: the scorer and the view at once, the whole engine at the first fit.

import { readFileSync } from "node:fs";
import { join } from "node:path";
import { brotliCompressSync } from "node:zlib";
import { ROOT } from "../lib/paths.mjs";

export const name = "size";
export const about = "wasm as served";

const MODULES = [
  { label: "scorer", path: "www/generated/scorer/scorer_bg.wasm", most: 190 },
  { label: "whole engine", path: "www/generated/engine/engine_bg.wasm" },
  { label: "STEP", path: "www/generated/cad/cad_bg.wasm" },
  { label: "HDF5", path: "www/generated/hdf5/hdf5_bg.wasm" },
  { label: "view", path: "www/generated/view/view_bg.wasm" },
];

/** @param {import("../lib/bench.mjs").Bench} bench */
export function measure(bench) {
  for (const { label, path, most } of MODULES) {
    const bytes = readFileSync(join(ROOT, path));
    bench.figure(`${label}, raw`, bytes.length / 1000, "kB", { digits: 1 });
    bench.figure(`${label}, brotli`, brotliCompressSync(bytes).length / 1000, "kB", {
      most,
      digits: 1,
    });
  }
}
