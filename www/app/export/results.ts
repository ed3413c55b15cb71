// What is on screen, in the form the formats of the command line take.

import { scoresOf } from "../../shared/formats/measures.mjs";
import type { Result, Row } from "../../shared/formats/results.mjs";
import { engine } from "../engine/client";
import type { MethodSummary, Protocol } from "../engine/contract";
import { isFitted, type ScoredRow } from "../state/models";
import { filesOfMethod, hashed } from "./hashes";

/** Each method's means over the reports, for the formats that show them. */
export function summariesOf(results: readonly Row[]): Promise<MethodSummary[]> {
  const scores = scoresOf(results);
  return engine.run((api) => api.summarise(scores));
}

export function engineVersion(): Promise<string> {
  return engine.run((api) => api.version());
}

/** The reports by a protocol as the formats take them, without the files that they were made of. */
export function unhashed(rows: readonly ScoredRow[], protocol: Protocol, version: string): Result[] {
  return rows.map(({ entry, reports }) => ({
    ...reports[protocol],
    engine: version,
    files: [],
    ...(isFitted(entry, reports.method) ? { surfacesFitted: true } : {}),
  }));
}

/** The reports by a protocol, each with the engine's version and the hashes of its files. */
export async function resultsOf(rows: readonly ScoredRow[], protocol: Protocol): Promise<Result[]> {
  const version = await engineVersion();
  const files = await Promise.all(rows.map(({ entry, reports }) => hashed(filesOfMethod(entry.source.files, reports.method))));
  return unhashed(rows, protocol, version).map((result, at) => ({ ...result, files: files[at] ?? [] }));
}
