// Which models belong together: those of one folder, as they were dropped.

export interface Placed {
  readonly id: string;
  /** Path of the cloud, or of any of its files where there is none. */
  readonly path: string | undefined;
}

/** Models without a folder of their own: pasted, or made here. */
export const LOOSE = "other models";
/** More sets than these would make a drawing each that nobody compares: then all are one. */
const MOST_SETS = 4;

/**
 * The models by set, named by the first folder in which their paths differ; in order of arrival. The training and
 * the test set of the whole repository are two, the folders per role of one of them are none.
 */
export function setsOf(models: readonly Placed[]): ReadonlyMap<string, readonly string[]> {
  const folders = new Map(models.map(({ id, path }) => [id, path?.split("/").slice(0, -1).map(bare) ?? []]));
  const deep = [...folders.values()].filter((own) => own.length > 0);
  const [first = []] = deep;
  let shared = 0;
  while (shared < first.length && deep.every((own) => own[shared] === first[shared])) shared += 1;
  const sets = new Map<string, string[]>();
  for (const { id } of models) {
    const own = folders.get(id) ?? [];
    const name = own[shared] ?? own.at(-1) ?? LOOSE;
    sets.set(name, [...(sets.get(name) ?? []), id]);
  }
  if (sets.size <= MOST_SETS) return sets;
  return new Map([["all models", models.map(({ id }) => id)]]);
}

/** A zip is a folder like others. */
function bare(folder: string): string {
  return folder.replace(/\.zip$/i, "");
}
