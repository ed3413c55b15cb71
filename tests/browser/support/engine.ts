// The engine under Node: makes the fixtures and says what the page should show.

import { readFileSync } from "node:fs";
import { join } from "node:path";
import { initSync, Model, type Protocol, type Report, type Role } from "../../../bin/engine/engine.js";
import { held } from "../../../scripts/lib/input.mjs";

export const ROOT = join(import.meta.dirname, "../../..");

initSync({ module: readFileSync(join(ROOT, "bin/engine/engine_bg.wasm")) });

export interface Fixture {
  readonly path: string;
  readonly text: string;
}

export const METHOD = "Imperfect";

interface Options {
  readonly spacing?: number;
  readonly seed?: number;
  /** Standard deviation, as a share of the diagonal. */
  readonly noise?: number;
  /** Points on no surface, as a share of all. */
  readonly outliers?: number;
}

/** The seven files of a generated part with its imperfect submission, in the layout of the public test set. */
export function filesOf(part: string, name: string, options: Options = {}): Fixture[] {
  return written(part, name, { spacing: 0.02, ...options });
}

function written(part: string, name: string, options: Options): Fixture[] {
  const model = Model.generate(part, options);
  model.imperfect(1);
  const files = filesWith(model, name, METHOD);
  model.free();
  return files;
}

/** The files of a model's truth and of one of its submissions. */
function filesWith(model: Model, name: string, method: string): Fixture[] {
  const truth = model.write();
  const found = model.write(method);
  return [
    { path: `pointCloud/${name}.txt`, text: truth.cloud ?? "" },
    { path: `pointCloud_primitives/${name}_primitives.txt`, text: truth.primitives },
    { path: `pointCloud_parametric/${name}_parametric.txt`, text: truth.parametric },
    { path: `pointCloud_implicit/${name}_implicit.txt`, text: truth.implicit },
    { path: `pointCloud_primitives_${method}/${name}_primitives.txt`, text: found.primitives },
    { path: `pointCloud_parametric_${method}/${name}_parametric.txt`, text: found.parametric },
    { path: `pointCloud_implicit_${method}/${name}_implicit.txt`, text: found.implicit },
  ];
}

/** What the engine says of the files. */
export function scoreOf(files: readonly Fixture[], protocol: Protocol = "definition", method = METHOD): Report {
  const model = Model.read(
    "",
    files.map(({ path, text }) => held({ ...roleOf(path), path }, new TextEncoder().encode(text))),
  );
  const report = model.score(method, protocol);
  model.free();
  return report;
}

/** What a sample scores with nothing said about its sampling. */
export function scoreOfSample(part: string, protocol: Protocol = "definition"): Report {
  return scoreOf(written(part, part, {}), protocol);
}

function roleOf(path: string): { role: Role; method?: string } {
  const [folder = ""] = path.split("/");
  const [, role = "cloud", method] = folder.split("_");
  return { role: role as Role, ...(method ? { method } : {}) };
}

/** What the files of a fit of a sample score, with the defaults of a method. */
export function scoreOfFit(part: string, method: "HT" | "PG", protocol: Protocol = "definition"): Report {
  const model = Model.generate(part, {});
  const name = model.fit(method === "HT" ? "ht" : "pg", {}, 1, () => {});
  const files = filesWith(model, part, name);
  model.free();
  return scoreOf(files, protocol, name);
}

/** What the files of fits of a model score, each with the defaults of its method. */
export function reportsOfFits(name: string, files: readonly Fixture[], methods: readonly ("HT" | "PG")[]): Report[] {
  const model = Model.read(
    name,
    files.map(({ path, text }) => held({ ...roleOf(path), path }, new TextEncoder().encode(text))),
  );
  const reports = methods.map((method) => {
    const submission = model.fit(method === "HT" ? "ht" : "pg", {}, 1, () => {});
    return { ...scoreOf(filesWith(model, name, submission), "definition", submission), model: name };
  });
  model.free();
  return reports;
}
