// A submission as a zip: its three files for each model, in the layout of the public test set, and
// a note of what made it.

import { SEGMENTATION } from "../../shared/roles.mjs";
import { engine } from "../engine/client";
import type { ModelEntry } from "../state/models";
import type { ModelFile, ModelSource } from "../../worker/protocol";
import { hashed } from "./hashes";
import { engineVersion } from "./results";
import type { Protocol } from "../engine/contract";
import { zip } from "./zip";

/** Zips a method's files. What the reader brought goes in unchanged; what is missing the engine writes. */
export async function zipSubmission(entries: readonly ModelEntry[], method: string, protocol: Protocol): Promise<Blob> {
  const files: ModelFile[] = [];
  for (const { id, source } of entries) files.push(...(await submissionOf(id, source, method)));
  const sums = await hashed(files);
  const note = {
    method,
    protocol,
    engine: await engineVersion(),
    files: sums.map(({ path, sha256 }) => ({ path, sha256 })),
  };
  const about = new Blob([`${JSON.stringify(note, null, 2)}\n`], { type: "application/json" });
  return zip([...files, { path: "fit4cad.json", data: about }]);
}

async function submissionOf(name: string, source: ModelSource, method: string): Promise<ModelFile[]> {
  const own = source.files.filter((file) => file.method === method);
  const missing = SEGMENTATION.some((role) => !own.some((file) => file.role === role));
  const written = missing ? await engine.run((api) => api.write(source, method)) : [];
  const paths = await engine.run((api) => api.submissionPaths(name, method));
  return SEGMENTATION.flatMap((role) => {
    const file = own.find((candidate) => candidate.role === role) ?? written.find((candidate) => candidate.role === role);
    return file ? [{ ...file, path: paths[role] }] : [];
  });
}
