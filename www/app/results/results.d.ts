// The standing table as the build hands it to the page.

declare module "*/method.toml" {
  const method: import("../../shared/results/method.mjs").Method;
  export default method;
}

declare module "*/sets.toml" {
  const sets: import("../../shared/results/sets.mjs").Sets;
  export default sets;
}
