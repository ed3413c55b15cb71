// Builds the wasm modules and, from them, the static page in www/dist.

import { createHash } from "node:crypto";
import { cpSync, existsSync, mkdirSync, readFileSync, renameSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { PUBLISHED, writeDeclared } from "./lib/declared.mjs";
import { ROOT, WASM_TARGET, npmCommand, tool } from "./lib/paths.mjs";
import { ask, isMain, main, run, runNode, say } from "./lib/run.mjs";
import { setup } from "./setup.mjs";

/** What rustc may emit for wasm32-unknown-unknown with SIMD on; wasm-opt keeps to these. */
const FEATURES = [
  "bulk-memory",
  "bulk-memory-opt",
  "call-indirect-overlong",
  "multivalue",
  "mutable-globals",
  "nontrapping-float-to-int",
  "reference-types",
  "sign-ext",
  "simd",
];
/** The lowest kilobyte is the end of the stack, where nothing lies; to know that saves more than a hundredth. */
const OPTIMISE = ["-O3", "--low-memory-unused", ...FEATURES.map((feature) => `--enable-${feature}`)];

/** Crate, name of the generated module, and the folders that get it; in another profile than `release` where one is named. */
const MODULES = [
  { crate: "fit4cad-engine", name: "engine", folders: ["www/generated/engine", "bin/engine"] },
  { crate: "fit4cad-scorer", name: "scorer", folders: ["www/generated/scorer"], profile: "small" },
  { crate: "fit4cad-cad", name: "cad", folders: ["www/generated/cad", "bin/cad"] },
  { crate: "fit4cad-hdf5", name: "hdf5", folders: ["www/generated/hdf5", "bin/hdf5"], profile: "small" },
  { crate: "fit4cad-view", name: "view", folders: ["www/generated/view"] },
];

const DECLARED = "www/generated/declared";

/** Builds the wasm modules; does nothing where neither sources nor tools have changed. */
export async function buildWasm() {
  for (const module of MODULES) {
    // One at a time: built together, the scorer would get every feature that the engine asks for.
    const build = ["build", "--profile", module.profile ?? "release", "--locked", "--quiet", "--target", WASM_TARGET];
    await run("cargo", [...build, "--package", module.crate]);
    await generate(module);
  }
  await declare();
}

/** Builds what a static host serves: www/dist. */
export async function buildPage() {
  await buildWasm();
  say("building the page into www/dist");
  await runNode(npmCommand("vite/bin/vite.js"), ["build", "--logLevel", "warn"]);
  await buildDocumentation();
}

/**
 * Puts the engine's documentation beside the page, where its About links to it. After the page, so that
 * the service worker keeps none of it: it is not needed to work offline.
 */
async function buildDocumentation() {
  say("documenting the engine into www/dist/doc");
  const folder = join(ROOT, "target/doc");
  rmSync(folder, { recursive: true, force: true });
  await run("cargo", ["doc", "--locked", "--quiet", "--no-deps", "--package", "fit4cad"], {
    env: { RUSTDOCFLAGS: "-D warnings" },
  });
  cpSync(folder, join(ROOT, "www/dist/doc"), { recursive: true });
}

/** @param {(typeof MODULES)[number]} module */
async function generate({ crate, name, folders, profile = "release" }) {
  const compiled = join(ROOT, "target", WASM_TARGET, profile, `${crate.replaceAll("-", "_")}.wasm`);
  const stamp = stampOf(compiled);
  if (folders.every((folder) => readStamp(folder) === stamp)) {
    return;
  }
  say(`binding and optimising ${name}`);
  const made = join(ROOT, "target/generated", name);
  rmSync(made, { recursive: true, force: true });
  await run(tool("wasm-bindgen"), [
    ...["--target", "web", "--out-name", name, "--out-dir", made, "--remove-producers-section"],
    compiled,
  ]);
  const wasm = join(made, `${name}_bg.wasm`);
  await runNode(npmCommand("binaryen/bin/wasm-opt"), [...OPTIMISE, wasm, "-o", `${wasm}.small`]);
  renameSync(`${wasm}.small`, wasm);
  writeFileSync(join(made, ".stamp"), stamp);
  // The page and Node get the very same files; Node hands the bytes to the same glue.
  for (const folder of folders) {
    const target = join(ROOT, folder);
    rmSync(target, { recursive: true, force: true });
    mkdirSync(target, { recursive: true });
    cpSync(made, target, { recursive: true });
  }
}

/** Writes out what Rust declares, unless that is done. */
async function declare() {
  const [engine, cad] = ["bin/engine", "bin/cad"];
  const published = createHash("sha256").update(readFileSync(PUBLISHED)).digest("hex");
  const stamp = `${readStamp(engine)} ${readStamp(cad)} ${published}`;
  if (readStamp(DECLARED) === stamp) {
    return;
  }
  await writeDeclared({ engine: join(ROOT, engine), cad: join(ROOT, cad) }, join(ROOT, DECLARED));
  writeFileSync(join(ROOT, DECLARED, ".stamp"), stamp);
}

/**
 * Changes whenever the compiled module or a tool that works on it does.
 * @param {string} compiled path of the module
 */
function stampOf(compiled) {
  const wasmOpt = readFileSync(npmCommand("binaryen/package.json"), "utf8");
  return createHash("sha256")
    .update(readFileSync(compiled))
    .update(ask(tool("wasm-bindgen"), ["--version"]) ?? "")
    .update(JSON.parse(wasmOpt).version)
    .update(OPTIMISE.join(" "))
    .digest("hex");
}

/** @param {string} folder */
function readStamp(folder) {
  const stamp = join(ROOT, folder, ".stamp");
  return existsSync(stamp) ? readFileSync(stamp, "utf8") : undefined;
}

if (isMain(import.meta.url)) {
  await main(async () => {
    await setup();
    await buildPage();
  });
}
