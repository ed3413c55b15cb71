// Reading clouds.

import { memory } from "../../www/shared/zip/source.mjs";
import { STREAMED, listZip } from "../../www/shared/zip/zip.mjs";
import { generatedZip, trainingZip } from "../lib/samples.mjs";
import { held } from "../lib/input.mjs";

export const name = "parse";
export const about = "reading PCi.txt, rows of numbers and PLY, bytes in memory to points";

const CLOUDS = 24;

/** What the same clouds are read as: how each is called, and its bytes made of the rows `x y z` of a `PCi.txt`. */
const FORMS = /** @type {const} */ ([
  { form: "PCi.txt", path: "PC1.txt", of: undefined, least: 100 },
  { form: "rows x y z", path: "PC1.xyz", of: (/** @type {string[]} */ rows) => new TextEncoder().encode(`${rows.join("\n")}\n`), least: undefined },
  { form: "PLY, text", path: "PC1.ply", of: (/** @type {string[]} */ rows) => new TextEncoder().encode(`${headOf("ascii", rows.length)}${rows.join("\n")}\n`), least: undefined },
  { form: "PLY, binary", path: "PC1.ply", of: binaryPly, least: undefined },
]);

/** @param {import("../lib/bench.mjs").Bench} bench */
export function measure(bench) {
  const zip = trainingZip();
  if (!zip) {
    bench.note("the public files are not at hand; generated parts instead");
  }
  const texts = listZip(memory(zip ?? generatedZip(bench.engine)), STREAMED)
    .entries.filter(({ path }) => !/_(primitives|parametric|implicit)\.txt$/.test(path))
    .slice(0, CLOUDS)
    .map(({ read }) => read());
  for (const { form, path, of, least } of FORMS) {
    const clouds = texts.map((text) => held({ path, role: "cloud" }, of ? of(rowsOf(text)) : text));
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
    bench.note(`${form}: ${clouds.length} clouds, ${points} points, ${megabytes.toFixed(1)} MB`);
    bench.figure(`${form}, bytes`, megabytes / seconds, "MB/s", { ...(least === undefined ? {} : { least }), digits: 0 });
    bench.figure(`${form}, points`, points / seconds / 1e6, "million/s");
  }
}

/**
 * The rows of a `PCi.txt`, as `x y z`.
 * @param {Uint8Array} text
 */
function rowsOf(text) {
  const rows = new TextDecoder().decode(text).matchAll(/\[([^[\],]+),([^[\],]+),([^[\],]+)\]/g);
  return Array.from(rows, (row) => row.slice(1).map((value) => value.trim()).join(" "));
}

/** @param {"ascii" | "binary_little_endian"} format @param {number} points */
function headOf(format, points) {
  return `ply\nformat ${format} 1.0\nelement vertex ${points}\nproperty double x\nproperty double y\nproperty double z\nend_header\n`;
}

/** @param {readonly string[]} rows */
function binaryPly(rows) {
  const head = new TextEncoder().encode(headOf("binary_little_endian", rows.length));
  const bytes = new Uint8Array(head.length + 24 * rows.length);
  bytes.set(head);
  const view = new DataView(bytes.buffer, head.length);
  for (const [at, value] of rows.flatMap((row) => row.split(" ")).entries()) view.setFloat64(8 * at, Number(value), true);
  return bytes;
}
