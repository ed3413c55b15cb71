// What the files on the page hash to. Each file is hashed once, in a worker, when it is first asked for.

import { engine } from "../engine/client";
import type { HashedFile } from "../../shared/formats/results.mjs";
import type { ModelFile } from "../../worker/protocol";

const known = new WeakMap<Blob, Promise<string | null>>();

/** The files with the SHA-256 of their bytes. */
export function hashed(files: readonly ModelFile[]): Promise<HashedFile[]> {
  const fresh = files.map(({ data }) => data).filter((data) => !known.has(data));
  if (fresh.length > 0) {
    const hashes = engine.run((api) => api.hash(fresh), { urgency: "background" });
    fresh.forEach((data, i) => {
      const hash = hashes.then((all) => all[i] ?? null);
      known.set(data, hash);
      // A worker that failed is no reason never to try again.
      hash.catch(() => known.delete(data));
    });
  }
  return Promise.all(
    files.map(async ({ path, role, method, data }) => ({
      path,
      role,
      ...(method === undefined ? {} : { method }),
      sha256: (await known.get(data)) ?? null,
    })),
  );
}

/** The files that make up a method's score: cloud, ground truth and its submission. */
export function filesOfMethod(files: readonly ModelFile[], method: string): ModelFile[] {
  return files.filter((file) => file.method === undefined || file.method === method);
}
