// What is fuzzed under Node: what is JavaScript, and the engine's boundary as JavaScript sees it.

/** @typedef {{ seeds: () => Uint8Array[] | Promise<Uint8Array[]>, run: (input: Uint8Array) => void | Promise<void> }} Body `run` throws where something is wrong */

/**
 * By name: the module, whose `load` gives the body, and how many runs a quick look gives it, a few seconds.
 * @type {readonly { name: string, quick: number, load: () => Promise<Body> }[]}
 */
export const NODE_TARGETS = [
  { name: "zip", quick: 10_000, load: async () => (await import("./targets/zip.mjs")).body },
  { name: "link", quick: 1_500, load: async () => (await import("./targets/link.mjs")).load() },
  { name: "formats", quick: 1_500, load: async () => (await import("./targets/formats.mjs")).body },
  { name: "standing", quick: 1_500, load: async () => (await import("./targets/standing.mjs")).body },
  { name: "cad", quick: 100, load: async () => (await import("./targets/cad.mjs")).load() },
  { name: "boundary", quick: 1_500, load: async () => (await import("./targets/boundary.mjs")).load() },
];
