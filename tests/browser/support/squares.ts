// Models that are what the published figures are of, by all that tells one.

import type { Fixture } from "./engine";

/** `truth` unit squares with `points` points in all: as many of both as PC1 has, and nothing else of it. */
export function squares(name: string, points: number, truth: number): Fixture[] {
  const cloud = Array.from({ length: points }, (_, i) => {
    const [layer, within] = [i % truth, Math.floor(i / truth)];
    return `[${(within % 31) / 31}, ${Math.floor(within / 31) / 31}, ${layer}]`;
  });
  const members = (layer: number) => cloud.flatMap((_, i) => (i % truth === layer ? i + 1 : [])).join(" ");
  const entries = (entry: (layer: number) => string) =>
    Array.from({ length: truth }, (_, layer) => `Primitive${layer + 1}:=[${entry(layer)}];\n`).join("");
  const primitives = entries(members);
  const parametric = entries((layer) => `Plane, [1 0 0 0 1 0 0 0 ${layer}]`);
  return [
    { path: `pointCloud/${name}.txt`, text: `Points:=[\n${cloud.join(", \n")} \n ];\n` },
    { path: `pointCloud_primitives/${name}_primitives.txt`, text: primitives },
    { path: `pointCloud_parametric/${name}_parametric.txt`, text: parametric },
    { path: `pointCloud_primitives_MINE/${name}_primitives.txt`, text: primitives },
    { path: `pointCloud_parametric_MINE/${name}_parametric.txt`, text: parametric },
  ];
}
