export * from "./bin/engine/engine.js";
export { default } from "./bin/engine/engine.js";
