// `fit4cad generate`.

import { mkdirSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { loadEngine } from "./engine.mjs";
import { reason } from "./inputs.mjs";
import { print, warn } from "./terminal.mjs";
import { UsageError, number, readArguments } from "./usage.mjs";

const OPTIONS = {
  list: { type: "boolean", default: false },
  seed: { type: "string" },
  spacing: { type: "string" },
  noise: { type: "string" },
  outliers: { type: "string" },
  missing: { type: "string" },
  imperfect: { type: "boolean", default: false },
  name: { type: "string" },
  out: { type: "string", default: "." },
};

/** Makes a part's files, or lists the parts; gives the exit code. */
export async function generate(args) {
  const { values, positionals } = readArguments(args, OPTIONS);
  const options = {
    seed: number("seed", values.seed, { least: 0, most: 2 ** 32 - 1, whole: true }),
    spacing: number("spacing", values.spacing, { least: 0 }),
    noise: number("noise", values.noise, { least: 0 }),
    outliers: number("outliers", values.outliers, { least: 0, most: 1 }),
    missing: number("missing", values.missing, { least: 0, most: 1 }),
  };
  const engine = await loadEngine();
  const parts = engine.parts();
  if (values.list) {
    if (positionals.length > 0) {
      throw new UsageError("--list takes no part");
    }
    await list(parts);
    return 0;
  }
  if (positionals.length !== 1) {
    throw new UsageError("give one part; --list shows them");
  }
  const [part] = positionals;
  if (!parts.some(({ name }) => name === part)) {
    throw new UsageError(`there is no part "${part}"; --list shows what there is`);
  }
  const name = values.name ?? part;
  if (!/^[^/\\]+$/.test(name)) {
    throw new UsageError(`--name ${name}: expected a name of files, without folders`);
  }
  return write(make(engine, part, options, { name, imperfect: values.imperfect }), values.out);
}

async function list(parts) {
  const width = Math.max(...parts.map(({ name }) => name.length));
  await print(parts.map(({ name, description }) => `${name.padEnd(width)}  ${description}\n`).join(""));
}

function make(engine, part, options, { name, imperfect }) {
  const given = Object.fromEntries(Object.entries(options).filter(([, value]) => value !== undefined));
  let model;
  try {
    model = engine.Model.generate(part, given);
  } catch (error) {
    // The engine says what is wrong with the options (a spacing of a millionth, say).
    throw new UsageError(error.message);
  }
  try {
    const truth = model.write();
    const files = { [`${name}.txt`]: truth.cloud, ...segmentation(truth, name) };
    if (!imperfect) {
      return files;
    }
    const method = model.imperfect(options.seed ?? 1);
    return { ...files, ...segmentation(model.write(method), join(method, name)) };
  } finally {
    model.free();
  }
}

function segmentation({ primitives, parametric, implicit }, name) {
  return {
    [`${name}_primitives.txt`]: primitives,
    [`${name}_parametric.txt`]: parametric,
    [`${name}_implicit.txt`]: implicit,
  };
}

async function write(files, folder) {
  try {
    for (const [file, text] of Object.entries(files)) {
      const path = join(folder, file);
      mkdirSync(dirname(path), { recursive: true });
      writeFileSync(path, text);
      await print(`${path}\n`);
    }
    return 0;
  } catch (error) {
    warn(`fit4cad generate: ${folder} could not be written: ${reason(error)}`);
    return 1;
  }
}
