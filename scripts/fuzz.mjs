// Fuzzes parsers and boundaries: `npm run fuzz [-- TARGET…] [--seconds N | --runs N] [--seed N] [--replay FILE] [--grow]`.
// `--quick` gives each a second or so, always the same.
// Without limits every target gets ten minutes, which makes hours.

import { spawn } from "node:child_process";
import { join } from "node:path";
import { buildFuzzer } from "./fuzz/build.mjs";
import { NODE_TARGETS } from "./fuzz/targets.mjs";
import { ROOT } from "./lib/paths.mjs";
import { Plain, isMain, main, print } from "./lib/run.mjs";

/** Seconds of a target when nothing is said. */
const USUAL_SECONDS = "600";
/** A number of its own for each target. */
const QUICK = "quick";

/** @typedef {{ name: string, quick: string, command: string, args: readonly string[] }} Runnable a target and what runs it */

/**
 * Runs a program to its end, whatever that is; its complaints go to the terminal.
 * @param {string} program
 * @param {readonly string[]} args
 * @returns {Promise<{ status: number | null, stdout: string }>} no status where a signal ended it
 */
function printed(program, args) {
  return new Promise((done, fail) => {
    const child = spawn(program, args, { cwd: ROOT, stdio: ["ignore", "pipe", "inherit"] });
    let stdout = "";
    child.stdout.setEncoding("utf8").on("data", (/** @type {string} */ text) => (stdout += text));
    child.on("error", fail);
    child.on("close", (status) => done({ status, stdout }));
  });
}

/** Every target, of Rust and of Node. */
async function allTargets() {
  const program = await buildFuzzer();
  const listed = (await printed(program, ["--list"])).stdout.trim().split("\n");
  const rust = listed.map((line) => {
    const [name = "", quick = ""] = line.split(" ");
    return { name, quick, command: program, args: [name] };
  });
  const script = join(ROOT, "scripts/fuzz/node.mjs");
  const node = NODE_TARGETS.map(({ name, quick }) => ({ name, quick: String(quick), command: process.execPath, args: [script, name] }));
  return { program, targets: /** @type {Runnable[]} */ ([...rust, ...node]) };
}

/**
 * Runs a target; gives how many runs it made and whether all were well.
 * @param {Runnable} target
 * @param {readonly string[]} options
 */
async function runTarget({ name, command, args }, options) {
  const once = async (/** @type {readonly string[]} */ more) => {
    const { status, stdout } = await printed(command, [...args, ...options, ...more]);
    print(stdout.trimEnd());
    return { status, runs: Number(/ (\d+) runs in [^\n]*\n$/.exec(stdout)?.[1] ?? 0) };
  };
  let { status, runs } = await once([]);
  if (status === null) {
    print(`${name}: ended without a word; once more, writing each input down before it is run`);
    ({ status, runs } = await once(["--careful"]));
    print(`${name}: the last input is crate/fuzz/found/${name}-last`);
  }
  return { well: status === 0, runs };
}

/**
 * Runs the targets of these names, or all, and throws where one found something.
 * @param {readonly string[]} names
 * @param {readonly string[]} options
 */
async function fuzz(names, options) {
  const { program, targets } = await allTargets();
  const planted = names.filter((name) => name.startsWith("planted-"));
  const known = [...targets, ...planted.map((name) => ({ name, quick: "300000", command: program, args: [name] }))];
  const unknown = names.find((name) => known.every((target) => target.name !== name));
  if (unknown !== undefined) {
    throw new Plain(`there is no target ${unknown}; there are ${targets.map(({ name }) => name).join(", ")}`);
  }
  const chosen = names.length > 0 ? known.filter(({ name }) => names.includes(name)) : targets;
  let total = 0;
  /** @type {string[]} */
  const failed = [];
  for (const target of chosen) {
    const { well, runs } = await runTarget(target, options.map((option) => (option === QUICK ? target.quick : option)));
    total += runs;
    if (!well) failed.push(target.name);
  }
  print(`\n${total.toLocaleString("en")} runs of ${chosen.length} targets`);
  if (failed.length > 0) {
    throw new Plain(`found something: ${failed.join(", ")}`);
  }
}

/** What `--quick` runs: a second or so of each target, always the same, and the fault that only counters lead to. */
export async function fuzzQuickly() {
  if (process.platform !== "win32") {
    const { program } = await allTargets();
    const { status, stdout } = await printed(program, ["planted-panic", "--runs", "300000"]);
    if (status !== 1 || !stdout.includes("planted-panic: a panic at")) {
      throw new Plain(`the fault planted behind four bytes was not found\n${stdout}`);
    }
  }
  await fuzz([], ["--runs", QUICK, "--seed", "1"]);
}

if (isMain(import.meta.url)) {
  await main(async () => {
    /** @type {string[]} */
    const names = [];
    /** @type {string[]} */
    const options = [];
    const given = process.argv.slice(2);
    if (given.includes("--quick")) {
      await fuzzQuickly();
      return;
    }
    for (let at = 0; at < given.length; at += 1) {
      const word = given[at] ?? "";
      if (!word.startsWith("-")) {
        names.push(word);
      } else {
        const alone = word === "--grow" || word === "--careful";
        options.push(word, ...(alone ? [] : given.slice(at + 1, at + 2)));
        at += alone ? 0 : 1;
      }
    }
    const limited = ["--runs", "--seconds", "--replay"].some((option) => options.includes(option));
    await fuzz(names, limited ? options : [...options, "--seconds", USUAL_SECONDS]);
  });
}
