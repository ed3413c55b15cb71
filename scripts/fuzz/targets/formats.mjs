// The text formats of results: whatever models, methods and files are called, and whatever is missing, a row stays a row.

import assert from "node:assert/strict";
import { loadEngine } from "../../../bin/cli/engine.mjs";
import { FORMATS } from "../../../www/shared/formats/index.mjs";
import { scoresOf } from "../../../www/shared/formats/measures.mjs";
import { Bytes } from "../bytes.mjs";

const engine = await loadEngine();
const model = engine.Model.generate("plate", { spacing: 0.08 });
const report = model.score(model.imperfect(1), "definition");

/**
 * How many cells each row of a CSV has, its first and one for each result.
 * @param {string} text
 */
function cellsOf(text) {
  const counts = [1];
  // What is in quotes is one cell, whatever it holds.
  for (const [mark] of text.replaceAll(/"(?:[^"]|"")*"/g, "").matchAll(/,|\r\n/g)) {
    if (mark === ",") counts[counts.length - 1] = (counts.at(-1) ?? 0) + 1;
    else counts.push(1);
  }
  return counts.slice(0, -1);
}

/** @type {import("../targets.mjs").Body} */
export const body = {
  seeds: () =>
    ["PC1\0HT\0PC1.txt\0", 'a|b\0"q",\n\0\\x & _ # % $ { } ~ ^\0', "=1+1\0-2\0@x\0", "\u{202e}\0\r\n\0\u{2028}\0", "`\0<b>\0[x](y)\0"].map((text) =>
      Uint8Array.from([2, ...new TextEncoder().encode(text), 3, 64, 70, 130, 11, 12]),
    ),
  run(input) {
    const bytes = new Bytes(input);
    const results = bytes.list(4, () => {
      const [name, method, path] = [bytes.text(), bytes.text(), bytes.text()];
      const means = Object.entries(report.mean).map(([measure, value]) => {
        const said = bytes.below(4);
        return [measure, said === 0 ? null : said === 1 ? bytes.number() : value];
      });
      return {
        ...report,
        ...{ model: name, method, engine: bytes.text(), mean: Object.fromEntries(means) },
        files: [{ path, role: /** @type {const} */ ("cloud"), sha256: bytes.below(2) === 0 ? null : "0".repeat(64) }],
      };
    });
    const summaries = results.length > 0 ? engine.summarise(scoresOf(results)) : [];
    for (const [name, { write }] of Object.entries(FORMATS)) {
      const text = write(results, summaries);
      assert.equal(typeof text, "string");
      if (name === "json") assert.equal(JSON.parse(text).length, results.length);
      else if (name === "csv") assert.deepEqual(new Set(cellsOf(text)).size, 1, "rows of different lengths");
      // eslint-disable-next-line no-control-regex -- they are what is looked for
      else assert.doesNotMatch(text, /[\u0000-\u0009\u000b-\u001f\u007f]/, name);
    }
    const lines = FORMATS.markdown.write(results, summaries).split("\n").filter((line) => line.startsWith("|"));
    const columns = new Set(lines.map((line) => line.replaceAll(/\\./g, "").split("|").length));
    assert.ok(columns.size <= 2, `rows of ${[...columns].join(", ")} columns`);
  },
};
