// What a picture or chart was made from, to be kept inside its file: the engine, the protocol and the
// hashes of the files.

import { scoredRows } from "../state/models";
import { protocol } from "../state/settings";
import { hashed } from "./hashes";
import { engineVersion } from "./results";

export interface Provenance {
  readonly engine: string;
  readonly protocol: string;
  readonly files: readonly { readonly path: string; readonly sha256: string | null }[];
}

/** Of the models with these names, or of all that are scored. */
export async function provenanceOf(models?: readonly string[]): Promise<Provenance> {
  const entries = new Set(scoredRows.peek().map(({ entry }) => entry));
  const wanted = [...entries].filter(({ id }) => models?.includes(id) ?? true);
  const files = await hashed(wanted.flatMap(({ source }) => source.files));
  return {
    engine: await engineVersion(),
    protocol: protocol.peek(),
    files: files.map(({ path, sha256 }) => ({ path, sha256 })),
  };
}
