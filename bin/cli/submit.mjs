// `fit4cad submit`.

import { existsSync, readFileSync } from "node:fs";
import { basename, join, resolve } from "node:path";
import { ID } from "../../www/shared/results/method.mjs";
import { few, writeScores } from "../../www/shared/results/scores.mjs";
import { tell } from "./diagnostics.mjs";
import { loadEngine } from "./engine.mjs";
import { FORMAT_OPTIONS, formatOf } from "./format.mjs";
import { collect } from "./inputs.mjs";
import { bareName } from "./standing/entry.mjs";
import { METHOD_FILE, RESULTS, SCORES_FILE, readFolder, setsOf, tableOf } from "./standing/folder.mjs";
import { Submission } from "./standing/submission.mjs";
import { template } from "./standing/template.mjs";
import { print, progress } from "./terminal.mjs";
import { UsageError, readArguments } from "./usage.mjs";
import { writeWhole } from "./write.mjs";

/** @typedef {import("./standing/words.mjs").Line} Line */

const OPTIONS = /** @type {const} */ ({
  to: { type: "string" },
  set: { type: "string" },
  method: { type: "string" },
  times: { type: "string" },
  ...FORMAT_OPTIONS,
});

/**
 * Checks a submission to the standing table as the table will, scores it and writes its folder; gives the
 * exit code.
 * @param {readonly string[]} args
 */
export async function submit(args) {
  const { values, positionals } = readArguments(args, OPTIONS);
  const format = formatOf(values, ["table", "json"]);
  const sets = setsOf(tableOf(values.to ?? RESULTS));
  const set = sets.sets.find(({ id }) => id === values.set);
  if (!set) throw new UsageError(`--set ${values.set ?? ""}: expected ${sets.sets.map(({ id }) => id).join(", ")}`);
  if (values.to === undefined) throw new UsageError(`say which folder is to be written: --to ${join(basename(RESULTS), "my-method")}`);
  const folder = resolve(values.to);
  const id = basename(folder);
  if (!ID.test(id)) throw new UsageError(`--to ${values.to}: a folder is called by small letters, digits and hyphens, at most 48`);
  if (positionals.length === 0) throw new UsageError("give at least one file, folder or zip with clouds, truth and answers");
  const times = values.times === undefined ? undefined : timesIn(values.times);

  /** @type {Line[]} */
  const lines = [];
  // As the steps are taken, so that a long one is not waited for in the dark.
  const say = async (/** @type {Line} */ line) => {
    lines.push(line);
    progress.clear();
    if (format === "table") await print(`${line.mark} ${line.text}\n`);
  };
  const engine = await loadEngine();
  progress.show("looking for files");
  const inputs = await collect(positionals);
  tell(engine, inputs.diagnostics);
  const submission = new Submission(engine, inputs.files, set, values.method);
  const scores = await submission.check(say, times);
  let isWritten = false;
  if (scores) {
    const before = readFolder(folder, sets);
    const kept = before.scores?.sets.filter((each) => each.set !== set.id) ?? [];
    const order = sets.sets.map((each) => each.id);
    const all = [...kept, scores].sort((one, other) => order.indexOf(one.set) - order.indexOf(other.set));
    if (!existsSync(join(folder, METHOD_FILE))) writeWhole(join(folder, METHOD_FILE), template(submission.method));
    writeWhole(join(folder, SCORES_FILE), writeScores({ format: 1, method: id, sets: all }));
    isWritten = true;
    await say({ mark: "✓", text: `written: ${join(values.to, SCORES_FILE)}, with ${all.map((each) => each.set).join(", ")}` });
    const { findings } = readFolder(folder, sets);
    for (const { where, message } of findings) await say({ mark: "✗", text: `${where}: ${message}` });
    if (findings.length === 0) await say({ mark: "✓", text: `${join(values.to, METHOD_FILE)} is whole: commit the folder and open a pull request` });
    else await say({ mark: "✗", text: `mend ${join(values.to, METHOD_FILE)} and run this again` });
  }
  progress.clear();
  if (format === "json") {
    await print(`${JSON.stringify({ id, set: set.id, written: isWritten, steps: lines.map(({ mark, text }) => ({ kind: KINDS[mark], text })) }, null, 2)}\n`);
  }
  return lines.some(({ mark }) => mark === "✗") || !isWritten ? 1 : 0;
}

const KINDS = { "✓": "done", "✗": "error", "!": "warning" };

/**
 * Seconds by model, out of what `fit4cad fit --json` printed or anything of its shape.
 * @param {string} path
 * @returns {ReadonlyMap<string, number>}
 */
function timesIn(path) {
  const wrong = `--times ${path}: expected a list of {"model": …, "seconds": …}, as fit4cad fit --json prints it`;
  /** @type {unknown} */
  let value;
  try {
    value = JSON.parse(readFileSync(path, "utf8"));
  } catch {
    throw new UsageError(wrong);
  }
  const rows = Array.isArray(value) ? value : [];
  const times = rows.flatMap((row) => {
    const [model, seconds] = typeof row === "object" && row !== null ? [Reflect.get(row, "model"), Reflect.get(row, "seconds")] : [];
    return typeof model === "string" && typeof seconds === "number" && seconds >= 0 ? [/** @type {const} */ ([bareName(model), seconds])] : [];
  });
  if (times.length === 0 || times.length < rows.length) throw new UsageError(wrong);
  const twice = times.map(([model]) => model).filter((model, at, all) => all.indexOf(model) !== at);
  if (twice.length > 0) throw new UsageError(`--times ${path}: ${few(twice)} has several times`);
  return new Map(times);
}
