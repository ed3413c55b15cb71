// Which models belong together: those of one folder, as they were dropped.

export interface Placed {
  readonly id: string;
  /** Path of the cloud, or of any of its files where there is none. */
  readonly path: string | undefined;
}

/** Models without a folder of their own: pasted, or made here. */
export const LOOSE = "other models";

/** The folders that keep the files of one set apart by what they are: `pointCloud`, `pointCloud_primitives`. */
const ROLE_FOLDER = /^(point_?clouds?|clouds|points)$|^(pointcloud_)?(primitives|parametric|implicit)(_|$)/i;

/**
 * The set of each model: the folder it was dropped in, that of its role left out. What a set is called depends on its
 * own path alone, but for two folders of one name, which are told apart by as many of those around them as it takes.
 */
export function setsOf(models: readonly Placed[]): ReadonlyMap<string, string> {
  const folders = new Map(models.map(({ id, path }) => [id, folderOf(path)]));
  const distinct = new Map([...folders.values()].map((folder) => [folder.join("/"), folder]));
  const shared = new Map<string, number>();
  for (const folder of distinct.values()) {
    for (const name of namesFor(folder)) shared.set(name, (shared.get(name) ?? 0) + 1);
  }
  const names = new Map(Array.from(distinct, ([whole, folder]) => [whole, folder.length === 0 ? LOOSE : nameOf(folder, shared)]));
  return new Map(Array.from(folders, ([id, folder]) => [id, names.get(folder.join("/")) ?? LOOSE]));
}

function folderOf(path: string | undefined): string[] {
  const folders = path?.split("/").slice(0, -1).map(bare) ?? [];
  return ROLE_FOLDER.test(folders.at(-1) ?? "") ? folders.slice(0, -1) : folders;
}

/** What a set may be called: its last folder, that with the one around it, and so on. */
function namesFor(folder: readonly string[]): string[] {
  return folder.map((_, at) => folder.slice(-(at + 1)).join("/"));
}

/** The shortest name that no other set shares, of whose names it is told how many sets each would fit. */
function nameOf(folder: readonly string[], shared: ReadonlyMap<string, number>): string {
  return namesFor(folder).find((name) => shared.get(name) === 1) ?? folder.join("/");
}

/** A zip is a folder like others. */
function bare(folder: string): string {
  return folder.replace(/\.zip$/i, "");
}
