// Steps of the test run: each timed, its tests counted from what its runner prints.

/** How the runners say what came of the tests: cargo and wasm-bindgen, node:test, Playwright. */
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
  },
  playwright: {
    passed: /^ +(\d+) passed/gm,
    // A test that passes only when repeated is not one to rely on.
    failed: /^ +(\d+) (?:failed|flaky|interrupted|did not run)/gm,
    skipped: /^ +(\d+) skipped/gm,
  },
};

// eslint-disable-next-line no-control-regex -- terminal colours
const COLOUR = /\u001b\[[0-9;]*m/g;

/** Sums what a runner prints. */
export function count(runner, output) {
  const plain = output.replace(COLOUR, "");
  const sum = (pattern) =>
    [...plain.matchAll(pattern)].reduce((total, [, number]) => total + Number(number), 0);
  const { passed, failed, skipped } = COUNTS[runner];
  return { passed: sum(passed), failed: sum(failed), skipped: sum(skipped) };
}

/**
 * Runs the steps in order. A step is `{ name, run, runner?, needs? }`; `run` gives the output to
 * count tests in. A failing step does not keep others from running, save those that need it.
 */
export async function runSteps(steps) {
  const results = [];
  for (const step of steps) {
    const missing = (step.needs ?? []).find((name) =>
      results.some((result) => result.name === name && result.outcome !== "ok"),
    );
    if (missing) {
      results.push({ name: step.name, outcome: `not run: ${missing} failed`, seconds: 0 });
      continue;
    }
    console.log(`\n── ${step.name}`);
    const start = performance.now();
    let outcome = "ok";
    let output = "";
    try {
      output = (await step.run()) ?? "";
    } catch (error) {
      outcome = "failed";
      output = error.output ?? "";
      console.error(error.message);
    }
    const counts = step.runner ? count(step.runner, output) : undefined;
    const nothing = counts && counts.passed + counts.failed + counts.skipped === 0;
    if (outcome === "ok" && nothing) {
      outcome = "failed";
      console.error(`${step.name}: not one test was found`);
    }
    results.push({ name: step.name, outcome, counts, seconds: (performance.now() - start) / 1000 });
  }
  return results;
}

/** Prints each step's result and duration, then the totals; gives whether all is well. */
export function summarise(results) {
  const total = { passed: 0, failed: 0, skipped: 0 };
  console.log("\n── summary");
  for (const { name, outcome, counts, seconds } of results) {
    const tests = counts
      ? `${counts.passed} passed, ${counts.failed} failed${counts.skipped ? `, ${counts.skipped} skipped` : ""}`
      : "";
    console.log(`${name.padEnd(30)} ${`${seconds.toFixed(1)} s`.padStart(8)}  ${outcome.padEnd(8)} ${tests}`);
    total.passed += counts?.passed ?? 0;
    total.skipped += counts?.skipped ?? 0;
    // A step that fails without a failing test (a lint, a build, a crash) is a failure too.
    total.failed += counts?.failed || (outcome === "ok" ? 0 : 1);
  }
  const skipped = total.skipped ? ` (${total.skipped} skipped)` : "";
  console.log(`\n${total.passed} passed, ${total.failed} failed${skipped}`);
  return total.failed === 0;
}
