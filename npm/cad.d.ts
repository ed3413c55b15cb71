export * from "./bin/cad/cad.js";
export { default } from "./bin/cad/cad.js";
