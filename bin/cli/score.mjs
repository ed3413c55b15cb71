// `fit4cad score`.

import { FORMATS } from "../formats/index.mjs";
import { corrections } from "./corrections.mjs";
import { inOneLine } from "./diagnostics.mjs";
import { loadEngine } from "./engine.mjs";
import { evaluate } from "./evaluate.mjs";
import { FORMAT_OPTIONS, formatOf } from "./format.mjs";
import { collect } from "./inputs.mjs";
import { print, progress, warn } from "./terminal.mjs";
import { UsageError, choice, readArguments } from "./usage.mjs";

const OPTIONS = {
  protocol: { type: "string", default: "definition" },
  ...FORMAT_OPTIONS,
  self: { type: "boolean", default: false },
  as: { type: "string", multiple: true, default: [] },
};

/** Scores what the arguments name; gives the exit code. */
export async function score(args) {
  const { values, positionals } = readArguments(args, OPTIONS);
  if (positionals.length === 0) {
    throw new UsageError("give at least one file, folder or zip");
  }
  const protocol = choice("protocol", values.protocol, ["definition", "published"]);
  const format = formatOf(values, Object.keys(FORMATS));
  const overrides = corrections(values.as);
  const engine = await loadEngine();

  progress.show("looking for files");
  const inputs = collect(positionals);
  refuseUnknown(Object.keys(overrides), inputs.files);
  const { results, diagnostics } = evaluate(engine, inputs.files, {
    protocol,
    overrides,
    self: values.self,
    progress: (text) => progress.show(`scoring ${text}`),
  });
  progress.clear();

  const problems = [...inputs.diagnostics, ...diagnostics];
  for (const problem of shownOnTerminal(problems, results, format)) {
    warn(inOneLine(problem));
  }
  if (results.length === 0) {
    warn("fit4cad score: nothing could be scored. A score needs a cloud, its truth and a submission; see fit4cad score --help.");
  }
  await print(FORMATS[format](results));
  const failed = results.length === 0 || problems.some(({ severity }) => severity === "error");
  return failed ? 1 : 0;
}

function refuseUnknown(corrected, files) {
  const known = new Set(files.map(({ path }) => path));
  for (const path of corrected.filter((candidate) => !known.has(candidate))) {
    throw new UsageError(`--as …:${path}: there is no such file among those given`);
  }
}

/** JSON holds the diagnostics of its reports itself; only the others are left for the terminal. */
function shownOnTerminal(problems, results, format) {
  if (format !== "json") {
    return problems;
  }
  const told = new Set(results.flatMap(({ diagnostics }) => diagnostics.map(inOneLine)));
  return problems.filter((problem) => !told.has(inOneLine(problem)));
}
