// The engine for bundlers and browsers: `await init()` fetches the wasm, then everything else can be called.

export * from "./bin/engine/engine.js";
export { default } from "./bin/engine/engine.js";
