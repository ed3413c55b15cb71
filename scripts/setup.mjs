// Brings a fresh machine with rustup and Node to where everything builds; quick when it is there already.

import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { ROOT, TOOLS, WASM_TARGET, tool } from "./lib/paths.mjs";
import { Plain, ask, isMain, main, run, say } from "./lib/run.mjs";

const OLDEST_NODE = "20.19";

export async function setup() {
  checkNode();
  await installPackages();
  checkRust();
  await addTarget();
  await installBindgen();
}

function checkNode() {
  if (isOlder(process.versions.node, OLDEST_NODE)) {
    throw new Plain(
      `Node ${process.versions.node} is too old: version ${OLDEST_NODE} or newer is needed (https://nodejs.org).`,
    );
  }
}

function checkRust() {
  if (ask("cargo", ["--version"]) === undefined) {
    throw new Plain(
      "cargo was not found. Install Rust with rustup (https://rustup.rs), open a new terminal and try again.",
    );
  }
  const manifest = readFileSync(join(ROOT, "Cargo.toml"), "utf8");
  const wanted = /^rust-version = "([\d.]+)"$/m.exec(manifest)?.[1];
  const found = /^rustc ([\d.]+)/.exec(ask("rustc", ["--version"]) ?? "")?.[1];
  if (wanted && found && isOlder(found, wanted)) {
    throw new Plain(
      `Rust ${found} is too old: version ${wanted} or newer is needed. \`rustup update stable\` fetches it (https://rustup.rs).`,
    );
  }
}

/**
 * Whether a version comes before another.
 * @param {string} version
 * @param {string} other
 */
export function isOlder(version, other) {
  const parts = version.split(".").map(Number);
  const others = other.split(".").map(Number);
  const at = others.findIndex((part, place) => part !== (parts[place] ?? 0));
  return at >= 0 && (parts[at] ?? 0) < (others[at] ?? 0);
}

async function addTarget() {
  const sysroot = ask("rustc", ["--print", "sysroot"]);
  if (sysroot && existsSync(join(sysroot, "lib/rustlib", WASM_TARGET))) {
    return;
  }
  if (ask("rustup", ["--version"]) === undefined) {
    throw new Plain(
      `Rust lacks the target ${WASM_TARGET}, and rustup, which would add it, was not found (https://rustup.rs).`,
    );
  }
  say(`adding the Rust target ${WASM_TARGET}`);
  await run("rustup", ["target", "add", WASM_TARGET]);
}

/** Whether every package of the lock file is there in the locked version. */
function packagesAreThere() {
  const installed = join(ROOT, "node_modules/.package-lock.json");
  if (!existsSync(installed)) {
    return false;
  }
  /** @type {(path: string) => Record<string, { version: string, optional?: boolean }>} */
  const read = (path) => JSON.parse(readFileSync(path, "utf8")).packages;
  const there = read(installed);
  return Object.entries(read(join(ROOT, "package-lock.json"))).every(
    ([path, { version, optional }]) =>
      path === "" || there[path]?.version === version || (optional && !there[path]),
  );
}

async function installPackages() {
  if (packagesAreThere()) {
    return;
  }
  say("installing the npm packages of package-lock.json");
  const npm = process.env.npm_execpath;
  const args = ["ci", "--no-audit", "--no-fund"];
  if (npm) {
    await run(process.execPath, [npm, ...args]);
  } else {
    await run("npm", args);
  }
}

/** The version that Cargo.toml pins: the crate and the command line must agree. */
function bindgenVersion() {
  const manifest = readFileSync(join(ROOT, "Cargo.toml"), "utf8");
  const pinned = /^wasm-bindgen = "=([\d.]+)"$/m.exec(manifest)?.[1];
  if (!pinned) {
    throw new Plain("Cargo.toml does not pin wasm-bindgen to one version (wasm-bindgen = \"=x.y.z\").");
  }
  return pinned;
}

async function installBindgen() {
  const version = bindgenVersion();
  if (ask(tool("wasm-bindgen"), ["--version"]) === `wasm-bindgen ${version}`) {
    return;
  }
  say(`building wasm-bindgen ${version} into .tools (once, a few minutes)`);
  await run("cargo", [
    ...["install", "wasm-bindgen-cli", "--locked", "--force"],
    ...["--version", version, "--root", TOOLS],
  ]);
}

if (isMain(import.meta.url)) {
  await main(async () => {
    await setup();
    say("everything needed is there");
  });
}
