// Running commands, and saying what is being done.

import { spawn, spawnSync } from "node:child_process";
import { pathToFileURL } from "node:url";
import { ROOT } from "./paths.mjs";

/** A failure the reader can act on; shown without a stack. */
export class Plain extends Error {}

export function say(text) {
  console.log(`• ${text}`);
}

/**
 * Runs a command in the checkout and waits for it. Its output goes to the terminal; with `capture`
 * it is also kept and returned. Throws when the command cannot be started or fails.
 */
export function run(command, args, { env = {}, capture = false } = {}) {
  return new Promise((done, fail) => {
    const child = spawn(command, args, {
      cwd: ROOT,
      env: { ...process.env, ...env },
      stdio: ["inherit", capture ? "pipe" : "inherit", capture ? "pipe" : "inherit"],
    });
    const chunks = [];
    for (const [stream, out] of [
      [child.stdout, process.stdout],
      [child.stderr, process.stderr],
    ]) {
      stream?.on("data", (chunk) => {
        chunks.push(chunk);
        out.write(chunk);
      });
    }
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
      fail(Object.assign(new Plain(`${[command, ...args].join(" ")} ${how}`), { output }));
    });
  });
}

/** Runs a script under this same Node. */
export function runNode(script, args = [], options) {
  return run(process.execPath, [script, ...args], options);
}

/** What a command prints, or undefined where it is missing or fails. */
export function ask(command, args) {
  const answer = spawnSync(command, args, { cwd: ROOT, encoding: "utf8" });
  return answer.status === 0 ? answer.stdout.trim() : undefined;
}

/** Runs the main function of a script; plain failures are shown plainly. */
export async function main(body) {
  try {
    await body();
  } catch (error) {
    console.error(error instanceof Plain ? `\n${error.message}` : error);
    process.exitCode = 1;
  }
}

/** Whether the module of this address is the script that Node was started with. */
export function isMain(url) {
  return process.argv[1] !== undefined && url === pathToFileURL(process.argv[1]).href;
}
