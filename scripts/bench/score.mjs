// From the bytes of a zip to every measure, in one thread.

import { evaluate } from "../../bin/cli/evaluate.mjs";
import { listZip } from "../../bin/cli/zip.mjs";
import { generatedZip, testSampleZip, trainingZip } from "../lib/samples.mjs";

export const name = "score";
export const about = "zip bytes to all measures, one thread";

export function measure(bench) {
  const sample = testSampleZip();
  if (sample) {
    scoreZip(bench, "test_sample, methods HT and PG", sample, { runs: 5, most: 0.6 });
  }
  const training = trainingZip();
  if (training) {
    scoreZip(bench, "training_set.zip against itself", training, { runs: 3, most: 8, self: true });
  }
  if (!sample && !training) {
    bench.note("the public files are not at hand; generated parts instead");
    scoreZip(bench, "generated parts against themselves", generatedZip(bench.engine), {
      runs: 5,
      self: true,
    });
  }
}

function scoreZip(bench, label, zip, { runs, most, self = false }) {
  const unpack = () => listZip(zip).entries.map((entry) => ({ ...entry, bytes: entry.read() }));
  const score = (files) => evaluate(bench.engine, files, { protocol: "definition", self });
  const unpacked = unpack().map(({ path, bytes }) => ({ path, read: () => bytes }));

  const { results } = score(unpacked);
  const whole = bench.seconds(runs, () => score(listZip(zip).entries));
  const engine = bench.seconds(runs, () => score(unpacked));
  bench.note(`${label}: ${results.length} submissions`);
  bench.figure("zip bytes to measures", whole, "s", { most, digits: 3 });
  bench.figure("of it the engine", engine, "s", { digits: 3 });
}
