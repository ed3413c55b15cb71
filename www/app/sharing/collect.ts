// What is on the page, as a link says it.

import type { Protocol } from "../engine/contract";
import { engineVersion } from "../export/results";
import { fitOf } from "../state/inbox";
import type { ScoredRow } from "../state/models";
import { fingerprintsOf } from "./fingerprints";
import type { Claim, SharedModel, SharedResults, SharedView } from "./shared";

/** What the reader looks at, by names as the page has them. */
export type Looking = Omit<SharedView, "model"> & { readonly model: string | undefined };

export async function collect(rows: readonly ScoredRow[], protocol: Protocol, looking: Looking): Promise<SharedResults> {
  const engine = await engineVersion();
  const entries = [...new Set(rows.map(({ entry }) => entry))];
  const models: SharedModel[] = [];
  const claims: Claim[] = [];
  for (const [place, entry] of entries.entries()) {
    const own = rows.filter((row) => row.entry === entry);
    const first = own[0]?.reports[protocol];
    if (!first) continue;
    let inputs: SharedModel["inputs"];
    for (const { reports } of own) {
      const { method, [protocol]: report } = reports;
      const prints = await fingerprintsOf(entry.source.files, method);
      inputs = prints.inputs;
      const fitted = fitOf(entry.id, method);
      claims.push({
        model: place,
        method,
        predicted: report.predicted,
        typeErrors: report.type_errors,
        mean: report.mean,
        ...(fitted && { fitted }),
        ...(prints.submission !== undefined && { submission: prints.submission }),
      });
    }
    models.push({
      name: entry.id,
      points: first.points,
      truth: first.truth,
      origin: entry.origin,
      ...(inputs !== undefined && { inputs }),
    });
  }
  const { model, ...rest } = looking;
  const place = entries.findIndex(({ id }) => id === model);
  return { engine, protocol, models, claims, ...(place >= 0 && { view: { ...rest, model: place } }) };
}
