// Reading clouds.

import { memory } from "../../www/shared/zip/source.mjs";
import { STREAMED, listZip } from "../../www/shared/zip/zip.mjs";
import { generatedZip, trainingZip } from "../lib/samples.mjs";
import { held } from "../lib/input.mjs";

export const name = "parse";
export const about = "reading PCi.txt, text in memory to points";

const CLOUDS = 24;

/** @param {import("../lib/bench.mjs").Bench} bench */
export function measure(bench) {
  const zip = trainingZip();
  if (!zip) {
    bench.note("the public files are not at hand; generated parts instead");
  }
  const clouds = listZip(memory(zip ?? generatedZip(bench.engine)), STREAMED)
    .entries.filter(({ path }) => !/_(primitives|parametric|implicit)\.txt$/.test(path))
    .slice(0, CLOUDS)
    .map(({ path, read }) => held({ path, role: "cloud" }, read()));
  const megabytes = clouds.reduce((sum, { size }) => sum + size, 0) / 1e6;
  let points = 0;
  const seconds = bench.seconds(7, () => {
    points = 0;
    for (const cloud of clouds) {
      const model = bench.engine.Model.read("PC1", [cloud]);
      points += model.info().points;
      model.free();
    }
  });
  bench.note(`${clouds.length} clouds, ${points} points, ${megabytes.toFixed(1)} MB`);
  bench.figure("text read", megabytes / seconds, "MB/s", { least: 100, digits: 0 });
  bench.figure("points read", points / seconds / 1e6, "million/s");
}
