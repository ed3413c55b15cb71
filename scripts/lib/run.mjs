// Running commands, and saying what is being done.

import { AsyncLocalStorage } from "node:async_hooks";
import { spawn, spawnSync } from "node:child_process";
import { StringDecoder } from "node:string_decoder";
import { pathToFileURL } from "node:url";
import { ROOT } from "./paths.mjs";

/** Where what is said and what commands print goes, where several things run side by side. */
/** @type {AsyncLocalStorage<(text: string) => void>} */
const sink = new AsyncLocalStorage();

/**
 * Does something whose every line, and those of the commands it runs, begin with a word.
 * @template T
 * @param {string} word
 * @param {() => Promise<T>} body
 * @returns {Promise<T>}
 */
export function marked(word, body) {
  let rest = "";
  const write = (/** @type {string} */ text) => {
    const lines = (rest + text).split("\n");
    rest = lines.pop() ?? "";
    process.stdout.write(lines.map((line) => `${word}${line}\n`).join(""));
  };
  return sink.run(write, async () => {
    try {
      return await body();
    } finally {
      if (rest !== "") write("\n");
    }
  });
}

/** @param {string} text a line, or several */
export function print(text) {
  const write = sink.getStore();
  if (write) write(`${text}\n`);
  else console.log(text);
}

/** @typedef {{ env?: NodeJS.ProcessEnv, capture?: boolean, cwd?: string }} RunOptions */

/** A failure the reader can act on; shown without a stack. */
export class Plain extends Error {}

/** A command that failed, with what it printed, where that was captured. */
export class Failed extends Plain {
  /**
   * @param {string} message
   * @param {string} output
   */
  constructor(message, output) {
    super(message);
    this.output = output;
  }
}

/** @param {string} text */
export function say(text) {
  print(`• ${text}`);
}

/**
 * Runs a command, in the checkout unless `cwd` says elsewhere, and waits for it. Its output goes to
 * the terminal; with `capture` it is also kept and returned. Throws when the command cannot be
 * started or fails.
 * @param {string} command
 * @param {readonly string[]} args
 * @param {RunOptions} options
 * @returns {Promise<string>} what it printed, where that was captured
 */
export function run(command, args, { env = {}, capture = false, cwd = ROOT } = {}) {
  const write = sink.getStore();
  const piped = capture || write ? "pipe" : "inherit";
  return new Promise((done, fail) => {
    const child = spawn(command, args, {
      cwd,
      env: { ...process.env, ...env },
      stdio: ["inherit", piped, piped],
    });
    /** @type {Buffer[]} */
    const chunks = [];
    /** @param {import("node:stream").Readable | null} stream @param {NodeJS.WriteStream} out */
    const pass = (stream, out) => {
      const letters = new StringDecoder("utf8");
      stream?.on("data", (/** @type {Buffer} */ chunk) => {
        if (capture) chunks.push(chunk);
        if (write) write(letters.write(chunk));
        else out.write(chunk);
      });
    };
    pass(child.stdout, process.stdout);
    pass(child.stderr, process.stderr);
    child.on("error", (error) => {
      fail(new Plain(`${command} could not be started: ${error.message}`));
    });
    child.on("close", (code, signal) => {
      const output = Buffer.concat(chunks).toString("utf8");
      if (code === 0) {
        done(output);
        return;
      }
      const how = signal ? `was ended by ${signal}` : `failed with code ${code}`;
      fail(new Failed(`${[command, ...args].join(" ")} ${how}`, output));
    });
  });
}

/**
 * Runs a script under this same Node.
 * @param {string} script
 * @param {readonly string[]} args
 * @param {RunOptions} [options]
 */
export function runNode(script, args = [], options) {
  return run(process.execPath, [script, ...args], options);
}

/**
 * What a command prints, or undefined where it is missing or fails.
 * @param {string} command
 * @param {readonly string[]} args
 */
export function ask(command, args) {
  const answer = spawnSync(command, args, { cwd: ROOT, encoding: "utf8" });
  return answer.status === 0 ? answer.stdout.trim() : undefined;
}

/**
 * Runs the main function of a script; plain failures are shown plainly.
 * @param {() => Promise<void>} body
 */
export async function main(body) {
  try {
    await body();
  } catch (error) {
    console.error(error instanceof Plain ? `\n${error.message}` : error);
    process.exitCode = 1;
  }
}

/**
 * Whether the module of this address is the script that Node was started with.
 * @param {string} url
 */
export function isMain(url) {
  return process.argv[1] !== undefined && url === pathToFileURL(process.argv[1]).href;
}
