// `fit4cad check`.

import { mkdirSync, writeFileSync } from "node:fs";
import { basename, join } from "node:path";
import { findings as table } from "../formats/findings.mjs";
import { inOneLine } from "./diagnostics.mjs";
import { loadEngine } from "./engine.mjs";
import { FORMAT_OPTIONS, formatOf } from "./format.mjs";
import { collect, reason, unusable } from "./inputs.mjs";
import { eachModel, isOfTruth } from "./models.mjs";
import { print, progress, warn } from "./terminal.mjs";
import { UsageError, readArguments } from "./usage.mjs";

const OPTIONS = {
  ...FORMAT_OPTIONS,
  write: { type: "string" },
};

/** Audits every ground truth that the arguments name; gives the exit code. */
export async function check(args) {
  const { values, positionals } = readArguments(args, OPTIONS);
  if (positionals.length === 0) {
    throw new UsageError("give at least one file, folder or zip");
  }
  const format = formatOf(values, ["table", "json"]);
  const engine = await loadEngine();

  progress.show("looking for files");
  const inputs = collect(positionals);
  const audits = [];
  const problems = [...inputs.diagnostics];
  const writer = values.write === undefined ? undefined : new Writer(values.write, problems);
  const show = (text) => progress.show(`checking ${text}`);
  const unread = eachModel(engine, inputs.files, { wanted: isOfTruth, progress: show }, (model) => {
    const { name, hasTruth } = model.info();
    audits.push(model.audit());
    if (!hasTruth) {
      problems.push(unusable(name, "there is no ground truth to check", `Give ${name}_primitives.txt as well`));
    } else {
      writer?.write(name, model.corrected());
    }
  });
  progress.clear();

  const told = [...problems, ...unread];
  for (const problem of told) {
    warn(inOneLine(problem));
  }
  if (audits.length === 0) {
    warn("fit4cad check: nothing could be checked. A check needs a cloud and its truth; see fit4cad check --help.");
  }
  for (const { path, numbers } of writer?.written ?? []) {
    warn(`wrote ${path}: replaced the vectors of primitives ${numbers.join(", ")}`);
  }
  await print(format === "json" ? `${JSON.stringify(audits, null, 2)}\n` : table(audits));
  const wrong = audits.some(({ findings }) => findings.some(({ severity }) => severity !== "note"));
  const failed = told.some(({ severity }) => severity === "error");
  return audits.length === 0 || wrong || failed ? 1 : 0;
}

/** Writes corrected surface files, each once, and remembers which. */
class Writer {
  constructor(folder, problems) {
    this.folder = folder;
    this.problems = problems;
    this.written = [];
    this.paths = new Set();
  }

  write(name, { corrections, ...texts }) {
    for (const form of ["parametric", "implicit"]) {
      if (texts[form] === undefined) {
        continue;
      }
      const path = join(this.folder, basename(`${name}_${form}.txt`));
      try {
        if (this.paths.has(path)) {
          throw new Error("two models have this name; check their folders one at a time");
        }
        this.paths.add(path);
        mkdirSync(this.folder, { recursive: true });
        writeFileSync(path, texts[form]);
        const own = corrections.filter((correction) => correction.form === form);
        this.written.push({ path, numbers: own.map(({ primitive }) => primitive) });
      } catch (error) {
        this.problems.push(unusable(path, `it could not be written: ${reason(error)}`));
      }
    }
  }
}
