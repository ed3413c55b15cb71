// `fit4cad fit`.

import { mkdirSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { align } from "../formats/align.mjs";
import { inOneLine } from "./diagnostics.mjs";
import { loadEngine } from "./engine.mjs";
import { fitAll } from "./fitting.mjs";
import { FORMAT_OPTIONS, formatOf } from "./format.mjs";
import { collect, reason } from "./inputs.mjs";
import { METHODS, givenParameters, parameterOptions } from "./parameters.mjs";
import { print, progress, warn } from "./terminal.mjs";
import { UsageError, choice, number, readArguments } from "./usage.mjs";

const OPTIONS = {
  method: { type: "string" },
  out: { type: "string" },
  ...FORMAT_OPTIONS,
  seed: { type: "string", default: "1" },
};

/** The results could not be written. */
class NotWritten extends Error {}

/** Fits what the arguments name; gives the exit code. */
export async function fit(args) {
  const engine = await loadEngine();
  const options = parameterOptions(engine);
  const flags = options.map(({ flag }) => [flag, { type: "string" }]);
  const { values, positionals } = readArguments(args, { ...OPTIONS, ...Object.fromEntries(flags) });
  if (values.method === undefined) {
    throw new UsageError("choose a method: --method ht or --method pg");
  }
  const method = choice("method", values.method.toLowerCase(), METHODS);
  const format = formatOf(values, ["table", "json"]);
  const seed = number("seed", values.seed, { least: 0, most: 2 ** 32 - 1, whole: true });
  const parameters = givenParameters(options, method, values);
  if (positionals.length === 0) {
    throw new UsageError("give at least one file, folder or zip");
  }

  progress.show("looking for files");
  const inputs = collect(positionals);
  const take = values.out === undefined ? () => {} : writer(values.out);
  let fitted;
  try {
    fitted = fitAll(engine, inputs.files, {
      ...{ method, parameters, seed, take },
      progress: (text) => progress.show(`fitting ${text}`),
    });
  } catch (error) {
    if (error instanceof NotWritten) {
      warn(`fit4cad fit: ${error.message}`);
      return 1;
    }
    throw error;
  }
  progress.clear();

  const { models } = fitted;
  const problems = [...inputs.diagnostics, ...fitted.diagnostics];
  for (const problem of problems) {
    warn(inOneLine(problem));
  }
  if (models.length === 0) {
    warn("fit4cad fit: there was no cloud to fit; see fit4cad fit --help.");
  }
  await print(format === "json" ? `${JSON.stringify(models, null, 2)}\n` : table(models));
  const failed = models.length === 0 || problems.some(({ severity }) => severity === "error");
  return failed ? 1 : 0;
}

/** Writes a submission's files below `out`, in the layout of the public test set. */
function writer(out) {
  return (model, method, texts) => {
    // A name may tell the set its model is of (`training_set/PC1`), but never lead out of `out`.
    const steps = model.split(/[\\/]/).filter((step) => !["", ".", ".."].includes(step));
    const name = steps.pop() ?? "model";
    for (const role of ["primitives", "parametric", "implicit"]) {
      const path = join(out, ...steps, `pointCloud_${role}_${method}`, `${name}_${role}.txt`);
      try {
        mkdirSync(dirname(path), { recursive: true });
        writeFileSync(path, texts[role]);
      } catch (error) {
        throw new NotWritten(`${path} could not be written: ${reason(error)}`);
      }
    }
  };
}

function table(models) {
  if (models.length === 0) {
    return "";
  }
  const types = ["Plane", "Cylinder", "Cone", "Sphere", "Torus"];
  const head = ["model", "points", "seconds", "primitives", ...types.map((type) => type.toLowerCase())];
  const rows = models.map(({ model, points, seconds, primitives }) => [
    model,
    String(points),
    seconds.toFixed(3),
    String(primitives.length),
    ...types.map((type) => String(primitives.filter((each) => each.type === type).length)),
  ]);
  return `${align([head, ...rows], 1)}\n`;
}
