// `fit4cad export`.

import { join } from "node:path";
import { EXPORTS } from "../../www/generated/declared/exports.js";
import { EXPORT_COLOURS } from "../../www/shared/palette.mjs";
import { SEGMENTATION } from "../../www/shared/roles.mjs";
import { STEP_FORM, TYPE_COLOURS, absence } from "../../www/shared/step.mjs";
import { loadCad } from "./cad.mjs";
import { corrections } from "./corrections.mjs";
import { tell } from "./diagnostics.mjs";
import { loadEngine } from "./engine.mjs";
import { collect, unusable } from "./inputs.mjs";
import { eachModel } from "./models.mjs";
import { print, progress, warn } from "./terminal.mjs";
import { UsageError, choice, readArguments } from "./usage.mjs";
import { makeFolder, problemOf, writeWhole } from "./write.mjs";

/** @typedef {import("../engine/engine.js").Model} Model */

const OPTIONS = /** @type {const} */ ({
  to: { type: "string", multiple: true, default: /** @type {string[]} */ ([]) },
  method: { type: "string" },
  out: { type: "string", default: "." },
  as: { type: "string", multiple: true, default: /** @type {string[]} */ ([]) },
});

/** The benchmark's own files, which are several. */
const OWN = "fit4cad";
/** Surfaces for CAD, which a module of its own writes. */
const STEP = STEP_FORM.name;
export const FORMS = [...EXPORTS.map(({ name }) => name), STEP, OWN];

/** What the truth is called among methods. */
const TRUTH = "truth";

/**
 * Writes the segmentations that the arguments name in the forms asked for; gives the exit code.
 * @param {readonly string[]} args
 */
export async function exportFiles(args) {
  const { values, positionals } = readArguments(args, OPTIONS);
  const forms = values.to.flatMap((list) => list.split(",")).map((form) => choice("to", form, FORMS));
  if (forms.length === 0) {
    throw new UsageError(`choose a form: --to ${FORMS.join(", ")}`);
  }
  if (positionals.length === 0) {
    throw new UsageError("give at least one file, folder or zip");
  }
  makeFolder(values.out);
  const engine = await loadEngine();
  const cad = forms.includes(STEP) ? await loadCad() : undefined;

  progress.show("looking for files");
  const inputs = await collect(positionals);
  const problems = [...inputs.diagnostics];
  /** @type {string[]} */
  const written = [];
  const how = { overrides: corrections(values.as), progress: (/** @type {string} */ text) => progress.show(`exporting ${text}`) };
  const read = await eachModel(engine, inputs.files, how, (model, _files, _place, able) => {
    const { name, hasTruth, methods, diagnostics } = model.info();
    problems.push(...diagnostics);
    const all = [...(hasTruth ? [TRUTH] : []), ...methods];
    const wanted = values.method === undefined ? all : all.filter((method) => method === values.method);
    if (wanted.length === 0) {
      problems.push(unusable(name, "there is no segmentation to export", `There is ${all.join(", ") || "none at all"}`));
    }
    for (const method of wanted) {
      for (const { path, content } of filesOf({ engine: able, cad, problems }, model, method, forms)) {
        const problem = problemOf(() => writeWhole(join(values.out, path), content));
        if (problem === undefined) {
          written.push(join(values.out, path));
        } else {
          problems.push(unusable(name, problem));
        }
      }
    }
  });
  progress.clear();
  tell(read.engine, [...problems, ...read.diagnostics]);
  if (written.length === 0) {
    warn("fit4cad export: nothing was written. An export needs a cloud and segments of it; see fit4cad export --help.");
  }
  await print(written.map((path) => `${path}\n`).join(""));
  return written.length === 0 || [...problems, ...read.diagnostics].some(({ severity }) => severity === "error") ? 1 : 0;
}

/**
 * @typedef {object} Writers
 * @property {import("./engine.mjs").Engine} engine
 * @property {import("./cad.mjs").Cad | undefined} cad where STEP is asked for
 * @property {import("./inputs.mjs").Diagnostic[]} problems what is not in a file is told here
 */

/**
 * The files of one segmentation, with their paths.
 * @param {Writers} writers
 * @param {Model} model
 * @param {string} called the method, or that of the truth
 * @param {readonly string[]} forms
 * @returns {{ path: string, content: string | Uint8Array }[]}
 */
function filesOf({ engine, cad, problems }, model, called, forms) {
  const { name } = model.info();
  const method = called === TRUTH ? undefined : called;
  const steps = name.split("/").map((step) => engine.fileName(step));
  const folders = steps.slice(0, -1);
  const stem = [...folders, engine.fileName(`${name.split("/").at(-1) ?? ""}_${called}`)].join("/");
  /** @type {{ path: string, content: string | Uint8Array }[]} */
  const files = [];
  for (const form of forms) {
    const known = EXPORTS.find((candidate) => candidate.name === form);
    if (known) {
      files.push({ path: stem + known.ending, content: model.export(form, method, EXPORT_COLOURS) });
      continue;
    }
    const texts = { ...model.write(method), cloud: model.cloud() };
    if (cad && form === STEP) {
      const { text, leftOut } = cad.writeStep(name, texts, TYPE_COLOURS);
      const path = stem + STEP_FORM.ending;
      if (leftOut > 0) problems.push(unusable(path, absence(leftOut), "", "warning"));
      files.push({ path, content: text });
      continue;
    }
    files.push({ path: engine.pathOf("test-set", name, "cloud"), content: texts.cloud });
    for (const role of SEGMENTATION) {
      files.push({ path: engine.pathOf("test-set", name, role, method), content: texts[role] });
    }
  }
  return files;
}
