// Models keep their names, whatever comes after them.

import type { Grouping } from "../engine/contract";

type Models = Grouping["models"];

/** The name on the page of the model that a file is part of, by the file's path. */
export type Names = ReadonlyMap<string, string>;

/**
 * The models under their names on the page, in the engine's order. The engine names all of a heap anew: what was `PC1`
 * becomes `test_set/PC1` where another of that name comes. Here a model that was on the page keeps its name; one that comes
 * gets the engine's, with a number where that is `taken`. A model is told by the first of its files that is known: its
 * cloud, where it has one.
 */
export function named(models: Models, known: Names, taken: Iterable<string>): Models {
  const claims = models.map(({ files }) => {
    const at = files.findIndex(({ path }) => known.has(path));
    return { at, name: known.get(files[at]?.path ?? "") };
  });
  const used = new Set(taken);
  const names: (string | undefined)[] = models.map(() => undefined);
  // Of two that a correction has made of one, the one that has kept its cloud keeps the name.
  const byClaim = models.map((_, index) => index).sort((a, b) => (claims[a]?.at ?? 0) - (claims[b]?.at ?? 0));
  for (const index of byClaim) {
    const name = claims[index]?.name;
    if (name === undefined || used.has(name)) continue;
    used.add(name);
    names[index] = name;
  }
  return models.map((model, index) => {
    const name = names[index] ?? freeName(model.name, used);
    used.add(name);
    return name === model.name ? model : { ...model, name };
  });
}

/** The names that files are known by after a heap was sorted. */
export function namesOf(models: Models): Names {
  return new Map(models.flatMap(({ name, files }) => files.map(({ path }) => [path, name] as const)));
}

/** The name itself, or the first with a number that is not taken. */
export function freeName(wanted: string, taken: ReadonlySet<string>): string {
  if (!taken.has(wanted)) return wanted;
  let number = 2;
  while (taken.has(`${wanted}-${number}`)) number += 1;
  return `${wanted}-${number}`;
}
