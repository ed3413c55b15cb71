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
  const all = [...distinct.values()];
  const names = new Map(Array.from(distinct, ([whole, folder]) => [whole, folder.length === 0 ? LOOSE : nameOf(folder, all)]));
  return new Map(Array.from(folders, ([id, folder]) => [id, names.get(folder.join("/")) ?? LOOSE]));
}

function folderOf(path: string | undefined): string[] {
  const folders = path?.split("/").slice(0, -1).map(bare) ?? [];
  return ROLE_FOLDER.test(folders.at(-1) ?? "") ? folders.slice(0, -1) : folders;
}

/** The last folder, and of those around it as many as no other set of that name has. */
function nameOf(folder: readonly string[], all: readonly (readonly string[])[]): string {
  for (let count = 1; count < folder.length; count += 1) {
    const name = folder.slice(-count).join("/");
    if (all.filter((other) => other.slice(-count).join("/") === name).length === 1) return name;
  }
  return folder.join("/");
}

/** A zip is a folder like others. */
function bare(folder: string): string {
  return folder.replace(/\.zip$/i, "");
}
