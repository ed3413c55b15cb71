// What reads and writes STEP, for bundlers and browsers: `await init()` first.

export * from "./bin/cad/cad.js";
export { default } from "./bin/cad/cad.js";
