// What is on screen, in the form the formats of the command line take.

import type { Result } from "../../../bin/formats/results.mjs";
import { engine } from "../engine/client";
import type { Protocol } from "../engine/contract";
import type { ScoredRow } from "../state/models";
import { filesOfMethod, hashed } from "./hashes";

export function engineVersion(): Promise<string> {
  return engine.run((api) => api.version());
}

/** The reports by a protocol, each with the engine's version and the hashes of its files. */
export async function resultsOf(rows: readonly ScoredRow[], protocol: Protocol): Promise<Result[]> {
  const version = await engineVersion();
  return Promise.all(
    rows.map(async ({ entry, reports }) => ({
      ...reports[protocol],
      engine: version,
      files: await hashed(filesOfMethod(entry.source.files, reports.method)),
    })),
  );
}
