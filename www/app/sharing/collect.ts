// What is on the page, as a link says it: each kind of content as its own module tells it.

import type { Protocol } from "../engine/contract";
import type { ScoredRow } from "../state/models";
import type { Origin } from "../state/origin";
import type { Fingerprints } from "./fingerprints";
import * as figures from "./kinds/figures";
import * as fit from "./kinds/fit";
import type { Page } from "./kinds/page";
import * as publicModel from "./kinds/public-model";
import * as sample from "./kinds/sample";
import * as view from "./kinds/view";
import type { Claim, SharedModel, SharedOrigin, SharedResults } from "./shared";

/** What is asked of the rest of the page. */
export interface Sources {
  readonly page: Pick<Page, "fitOf">;
  readonly engine: string;
  readonly fingerprintsOf: (row: ScoredRow) => Promise<Fingerprints>;
}

export async function collect(rows: readonly ScoredRow[], protocol: Protocol, looked: view.Look | undefined, sources: Sources): Promise<SharedResults> {
  const groups = byModel(rows);
  const models: SharedModel[] = [];
  const claims: Claim[] = [];
  for (const [place, [id, own]] of [...groups].entries()) {
    let told: SharedModel | undefined;
    for (const row of own) {
      const { method, [protocol]: report } = row.reports;
      const { model, claim } = figures.collect(report);
      const { inputs, submission } = await sources.fingerprintsOf(row);
      const fitted = fit.collect(id, method, sources.page);
      claims.push({ model: place, method, ...claim, ...(fitted && { fitted }), ...(submission !== undefined && { submission }) });
      told ??= { name: id, ...model, origin: collectOrigin(row.entry.origin), ...(inputs !== undefined && { inputs }) };
    }
    if (told) models.push(told);
  }
  const seen = looked && view.collect(looked, [...groups.keys()]);
  return { engine: sources.engine, protocol, models, claims, ...(seen && { view: seen }) };
}

/** The rows of each model, by its name, in the order in which models first appear. */
function byModel(rows: readonly ScoredRow[]): ReadonlyMap<string, readonly ScoredRow[]> {
  const groups = new Map<string, ScoredRow[]>();
  for (const row of rows) {
    const { id } = row.entry;
    const own = groups.get(id);
    if (own) own.push(row);
    else groups.set(id, [row]);
  }
  return groups;
}

function collectOrigin(origin: Origin): SharedOrigin {
  switch (origin.kind) {
    case "files":
      return origin;
    case "sample":
      return sample.collect(origin);
    case "public":
      return publicModel.collect(origin);
  }
}
