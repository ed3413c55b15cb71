// Steps of the test run: each timed, its tests counted from what its runner prints.

import { Failed, Plain, marked, print, run } from "./run.mjs";

/** A step that cannot be run on this machine, and why: no failure, but told. */
export class Skipped extends Plain {}

/**
 * How the runners say what came of the tests: cargo and wasm-bindgen, node:test, Playwright, pytest. Repeated
 * ones passed at the second attempt: told, to be looked into, but a busy machine alone fails no run.
 */
const COUNTS = {
  cargo: {
    passed: /^test result: .*?(\d+) passed/gm,
    failed: /^test result: .*?(\d+) failed/gm,
    skipped: /^test result: .*?(\d+) ignored/gm,
  },
  node: {
    passed: /^\S+ pass (\d+)$/gm,
    failed: /^\S+ (?:fail|cancelled) (\d+)$/gm,
    skipped: /^\S+ (?:skipped|todo) (\d+)$/gm,
    // Said by `runNodeTests`, not by Node.
    repeated: /^\S+ repeated (\d+)$/gm,
  },
  playwright: {
    passed: /^ +(\d+) passed/gm,
    failed: /^ +(\d+) (?:failed|interrupted|did not run)/gm,
    skipped: /^ +(\d+) skipped/gm,
    repeated: /^ +(\d+) flaky/gm,
  },
  pytest: {
    passed: /\b(\d+) passed\b.* in [\d.]+s/gm,
    failed: /\b(\d+) (?:failed|errors?)\b(?=.* in [\d.]+s)/gm,
    skipped: /\b(\d+) (?:skipped|xfailed)\b.* in [\d.]+s/gm,
  },
};

/** Where each runner tells once more, at its end, which tests failed and why. */
const FAULTS = {
  cargo: /^---- .* stdout ----$[^]*?(?=^(?:---- |failures:$))/gm,
  node: /^✖ failing tests:$[^]*/gm,
  playwright: /^ {2}1\) [^]*/gm,
  pytest: /^=+ FAILURES =+$[^]*/gm,
};

/** Where more files fail than this, it is no accident. */
const MOST_REPEATED = 2;

/** Lines of one step's faults that are told again: the first, which are nearest to the cause. */
const FAULT_LINES = 60;

// eslint-disable-next-line no-control-regex -- terminal colours
const COLOUR = /\u001b\[[0-9;]*m/g;

/** Matches no line. */
const NOTHING = /(?!)/g;

/** @typedef {keyof typeof COUNTS} Runner */

/**
 * @typedef {object} Step
 * @property {string} name
 * @property {"rust" | "page"} lane two lanes go side by side, in each the steps one after the other
 * @property {() => Promise<string | void>} run gives the output to count tests in
 * @property {Runner} [runner]
 * @property {readonly string[]} [needs] names of the steps without which it is not run
 */

/** @typedef {{ name: string, outcome: string, seconds: number, counts?: ReturnType<typeof count>, faults?: string }} StepResult */

/**
 * Sums what a runner prints.
 * @param {Runner} runner
 * @param {string} output
 */
export function count(runner, output) {
  const plain = output.replace(COLOUR, "");
  /** @param {RegExp} pattern */
  const sum = (pattern) =>
    [...plain.matchAll(pattern)].reduce((total, [, number]) => total + Number(number), 0);
  const { passed, failed, skipped, repeated } = { repeated: NOTHING, ...COUNTS[runner] };
  return { passed: sum(passed) + sum(repeated), failed: sum(failed), skipped: sum(skipped), repeated: sum(repeated) };
}

/**
 * What a failed step has printed of its faults, shortened; where its runner tells none, its last lines.
 * @param {Runner | undefined} runner
 * @param {string} output
 */
export function faults(runner, output) {
  const plain = output.replace(COLOUR, "").trimEnd();
  const told = runner ? [...plain.matchAll(FAULTS[runner])].map(([text]) => text.trimEnd()).join("\n") : "";
  const lines = (told || plain).split("\n");
  if (lines.length <= FAULT_LINES) return lines.join("\n");
  const kept = told ? lines.slice(0, FAULT_LINES) : lines.slice(-FAULT_LINES);
  return [...kept, `… ${lines.length - FAULT_LINES} lines more above`].join("\n");
}

/**
 * Runs files of tests under Node; those that fail are run once more, alone. Gives the output to count tests in.
 * @param {readonly string[]} files
 */
export async function runNodeTests(files) {
  const tests = (/** @type {readonly string[]} */ of) => run(process.execPath, ["--test", "--test-reporter", "spec", ...of], { capture: true });
  try {
    return await tests(files);
  } catch (error) {
    const again = error instanceof Failed ? failedFiles(error.output) : [];
    if (again.length === 0 || again.length > MOST_REPEATED) throw error;
    print(`\n── once more: ${again.join(", ")}`);
    await tests(again);
    return /** @type {Failed} */ (error).output.replaceAll(/^(\S+) fail (\d+)$/gm, "$1 repeated $2");
  }
}

/**
 * Where the tests are that Node says have failed.
 * @param {string} output
 */
export function failedFiles(output) {
  const places = faults("node", output).matchAll(/^test at (.+):\d+:\d+$/gm);
  return [...new Set([...places].flatMap(([, path]) => path ?? []))];
}

/**
 * Runs the steps of each lane in order, the lanes side by side. A failing step does not keep others
 * from running, save those that need it; of the steps that are not run at all nothing is needed.
 * @param {readonly Step[]} steps
 */
export async function runSteps(steps) {
  /** @type {Map<string, Promise<StepResult>>} */
  const results = new Map();
  const lanes = new Set(steps.map(({ lane }) => lane));
  for (const lane of lanes) {
    /** @type {Promise<unknown>} */
    let before = Promise.resolve();
    for (const step of steps.filter((step) => step.lane === lane)) {
      const turn = before;
      const start = () => runStep(step, results);
      const result = turn.then(() => (lanes.size > 1 ? marked(`${lane} │ `, start) : start()));
      results.set(step.name, result);
      before = result;
    }
  }
  return Promise.all(steps.map(({ name }) => /** @type {Promise<StepResult>} */ (results.get(name))));
}

/**
 * @param {Step} step
 * @param {ReadonlyMap<string, Promise<StepResult>>} results
 * @returns {Promise<StepResult>}
 */
async function runStep(step, results) {
  for (const name of step.needs ?? []) {
    const needed = await results.get(name);
    if (needed && needed.outcome !== "ok") {
      return { name: step.name, outcome: `not run: ${name} failed`, seconds: 0 };
    }
  }
  print(`\n── ${step.name}`);
  const start = performance.now();
  let outcome = "ok";
  let output = "";
  try {
    output = (await step.run()) ?? "";
  } catch (error) {
    outcome = error instanceof Skipped ? "skipped" : "failed";
    const message = String(error instanceof Error ? error.message : error);
    output = (error instanceof Failed && error.output) || message;
    print(message);
  }
  const counts = step.runner && outcome !== "skipped" ? count(step.runner, output) : undefined;
  const nothing = counts && counts.passed + counts.failed + counts.skipped === 0;
  if (outcome === "ok" && nothing) {
    outcome = "failed";
    print(`${step.name}: not one test was found`);
  }
  return {
    name: step.name,
    outcome,
    ...(counts ? { counts } : {}),
    ...((outcome === "failed" || counts?.repeated) && output !== "" ? { faults: faults(step.runner, output) } : {}),
    seconds: (performance.now() - start) / 1000,
  };
}

/** @param {ReturnType<typeof count>} counts */
function written({ passed, failed, skipped, repeated }) {
  const also = [skipped && `${skipped} skipped`, repeated && `${repeated} only when repeated`].filter(Boolean);
  return [`${passed} passed`, `${failed} failed`, ...also].join(", ");
}

/**
 * Prints what failed, each step's result and duration, then the totals; gives whether all is well.
 * @param {readonly StepResult[]} results
 */
export function summarise(results) {
  const total = { passed: 0, failed: 0, skipped: 0 };
  for (const { name, outcome, faults } of results) {
    if (faults) console.log(`\n── what failed${outcome === "ok" ? " at first" : ""}: ${name}\n${faults}`);
  }
  console.log("\n── summary");
  for (const { name, outcome, counts, seconds } of results) {
    const tests = counts ? written(counts) : "";
    console.log(`${name.padEnd(30)} ${`${seconds.toFixed(1)} s`.padStart(8)}  ${outcome.padEnd(8)} ${tests}`);
    total.passed += counts?.passed ?? 0;
    total.skipped += counts?.skipped ?? (outcome === "skipped" ? 1 : 0);
    // A step that fails without a failing test (a lint, a build, a crash) is a failure too.
    total.failed += counts?.failed || (outcome === "ok" || outcome === "skipped" ? 0 : 1);
  }
  const skipped = total.skipped ? ` (${total.skipped} skipped)` : "";
  console.log(`\n${total.passed} passed, ${total.failed} failed${skipped}`);
  return total.failed === 0;
}
