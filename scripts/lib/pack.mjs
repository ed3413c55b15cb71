// The npm package: engine and command line, with what they import, in the places where they import it.

import { cpSync, existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { ROOT } from "./paths.mjs";
import { Plain, run } from "./run.mjs";

const FOLDER = join(ROOT, "target/npm/fit4cad");

/** What goes in, from the checkout, under the same path. */
const COPIED = ["bin", "www/shared", "www/generated/declared", "LICENSE-APACHE", "LICENSE-MIT"];
/** Handed on inside, so that nothing else is fetched. */
const BUNDLED = "fflate";

/** Puts the package together; gives its folder. Needs the wasm built. */
export function assemble() {
  if (!existsSync(join(ROOT, "bin/engine/engine_bg.wasm"))) {
    throw new Plain("The engine is not built yet: run `npm run build`.");
  }
  rmSync(FOLDER, { recursive: true, force: true });
  mkdirSync(FOLDER, { recursive: true });
  for (const path of COPIED) {
    cpSync(join(ROOT, path), join(FOLDER, path), { recursive: true, filter: (from) => !from.endsWith(".stamp") });
  }
  cpSync(join(ROOT, "npm"), FOLDER, { recursive: true });
  // Types that the declared lists refer to: those of the engine beside the command line.
  const types = join(FOLDER, "www/generated/engine");
  mkdirSync(types, { recursive: true });
  writeFileSync(join(types, "engine.d.ts"), 'export * from "../../../bin/engine/engine.js";\n');
  cpSync(join(ROOT, "node_modules", BUNDLED), join(FOLDER, "node_modules", BUNDLED), { recursive: true });
  writeFileSync(join(FOLDER, "package.json"), `${JSON.stringify(manifest(), null, 2)}\n`);
  return FOLDER;
}

/**
 * Packs it; gives the path of the tarball.
 * @param {string} [out] the folder that gets it
 */
export async function pack(out = join(ROOT, "target/npm")) {
  const folder = assemble();
  mkdirSync(out, { recursive: true });
  const { name, version } = manifest();
  await npm(["pack", "--silent", "--pack-destination", out], folder);
  return join(out, `${name}-${version}.tgz`);
}

/**
 * Runs npm, of the version that runs this where that is known.
 * @param {readonly string[]} args
 * @param {string} cwd
 */
export function npm(args, cwd) {
  const script = process.env.npm_execpath;
  const isNpm = script?.endsWith("npm-cli.js");
  if (script && isNpm) return run(process.execPath, [script, ...args], { cwd, capture: true });
  // Node starts no .cmd without a shell.
  return process.platform === "win32"
    ? run("cmd.exe", ["/d", "/c", "npm", ...args], { cwd, capture: true })
    : run("npm", args, { cwd, capture: true });
}

function manifest() {
  /** @type {{ version: string, license: string, engines: object, dependencies: Record<string, string> }} */
  const { version, license, engines, dependencies } = JSON.parse(readFileSync(join(ROOT, "package.json"), "utf8"));
  return {
    name: "fit4cad",
    version,
    description: "Fit, score and read planes, cylinders, cones, spheres and tori in point clouds of CAD objects",
    keywords: ["fit4cad", "point-cloud", "primitive-fitting", "benchmark", "cad", "wasm"],
    license,
    type: "module",
    engines,
    bin: { fit4cad: "bin/fit4cad.mjs" },
    types: "./index.d.ts",
    exports: {
      ".": { types: "./index.d.ts", node: "./node.mjs", default: "./index.mjs" },
      "./cad": { types: "./cad.d.ts", node: "./cad-node.mjs", default: "./cad.mjs" },
      "./engine.wasm": "./bin/engine/engine_bg.wasm",
      "./cad.wasm": "./bin/cad/cad_bg.wasm",
      "./package.json": "./package.json",
    },
    dependencies: { [BUNDLED]: dependencies[BUNDLED] },
    bundleDependencies: [BUNDLED],
  };
}
