// Reading parts from CAD.

import { cadInstance } from "../../bin/cli/cad.mjs";
import { stepParts, stepPlate } from "../lib/samples.mjs";

export const name = "step";
export const about = "STEP files, bytes in memory to 20,000 points spread evenly";

const POINTS = 20_000;
/** Bytes from which on what a file needs is seen beside what any needs. */
const LARGE = 200_000;
/** Memory for each byte of a file. */
const MOST_MEMORY = 20;

/** @param {import("../lib/bench.mjs").Bench} bench */
export async function measure(bench) {
  const parts = stepParts();
  if (parts.length === 0) {
    bench.note("the STEP files are not at hand; one plate instead");
    parts.push({ path: "plate.step", bytes: Buffer.from(stepPlate()) });
  }
  const rows = [];
  for (const { path, bytes } of parts) {
    const { cad, memory } = await cadInstance();
    const before = memory.buffer.byteLength;
    cad.Part.read(bytes).free();
    const held = (memory.buffer.byteLength - before) / bytes.length;
    let faces = 0;
    const seconds = bench.seconds(3, () => {
      const part = cad.Part.read(bytes);
      const sampled = part.sample("part", { points: POINTS });
      faces = sampled.report().faces.length;
      sampled.free();
      part.free();
    });
    rows.push({ path, bytes: bytes.length, faces, seconds, held });
  }
  bench.table({
    title: "Parts",
    head: ["file", "kB", "faces", "s"],
    rows: rows.map(({ path, bytes, faces, seconds }) => [path, (bytes / 1e3).toFixed(0), String(faces), seconds.toFixed(3)]),
  });
  const times = rows.map(({ seconds }) => seconds).sort((a, b) => a - b);
  bench.figure("median", times[times.length >> 1] ?? 0, "s", { most: 0.15, digits: 3 });
  bench.figure("worst", times.at(-1) ?? 0, "s", { most: 3, digits: 3 });
  const large = rows.filter(({ bytes }) => bytes >= LARGE).map(({ held }) => held);
  if (large.length > 0) bench.figure("memory to read one, over its bytes", Math.max(...large), "times", { most: MOST_MEMORY, digits: 1 });
}
