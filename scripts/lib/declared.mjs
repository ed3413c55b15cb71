// What the engine declares, as modules that page, command line and formats import before any engine
// is loaded: one module a list, so that each part of the page carries what it shows and no more.

import { mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";

/**
 * Writes a module for each list that an engine declares.
 * @param {string} engine folder of the engine, as wasm-bindgen made it
 * @param {string} folder where the modules go, emptied before
 */
export async function writeDeclared(engine, folder) {
  // Another address each time: the engine may have been built anew since it was last imported.
  const glue = `${pathToFileURL(join(engine, "engine.js")).href}?built=${Date.now()}`;
  const { declarations, initSync } = await import(glue);
  initSync({ module: readFileSync(join(engine, "engine_bg.wasm")) });
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  for (const [key, list] of Object.entries(declarations())) {
    const words = key.split(/(?=[A-Z])/);
    const file = join(folder, words.join("-").toLowerCase());
    const name = words.join("_").toUpperCase();
    writeFileSync(`${file}.js`, `export const ${name} = ${JSON.stringify(list)};\n`);
    writeFileSync(
      `${file}.d.ts`,
      `import type { Declarations } from "../engine/engine.js";\n\nexport declare const ${name}: Readonly<Declarations["${key}"]>;\n`,
    );
  }
}
