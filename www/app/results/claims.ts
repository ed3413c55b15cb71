// A row as a link of claimed figures: opened on the page, its files can be had again, or dropped, and every digit
// of it is checked by the page itself.

import type { Method } from "../../shared/results/method.mjs";
import type { Entry, SetScores } from "../../shared/results/scores.mjs";
import type { ModelSet } from "../../shared/results/sets.mjs";
import type { Protocol } from "../engine/contract";
import { fingerprint } from "../sharing/fingerprints";
import type { Claim, SharedModel, SharedOrigin, SharedResults } from "../sharing/shared";
import type { HashedFile } from "../../shared/formats/results.mjs";

/** The claims of a method about models of a set. */
export async function claimsOf(method: Method, set: ModelSet, { engine }: Pick<SetScores, "engine">, entries: readonly Entry[], protocol: Protocol): Promise<SharedResults> {
  const rows = await Promise.all(entries.map((entry, place) => claimOf(method, set, entry, place, protocol)));
  const only = rows.length === 1 ? { view: { model: 0, method: method.answers.called } } : {};
  return { engine, protocol, models: rows.map(({ model }) => model), claims: rows.map(({ claim }) => claim), ...only };
}

async function claimOf(method: Method, set: ModelSet, entry: Entry, place: number, protocol: Protocol): Promise<{ model: SharedModel; claim: Claim }> {
  const [inputs, submission] = await Promise.all([printOf(entry.inputs), printOf(entry.answers)]);
  const { model: name, points, truth, predicted, typeErrors } = entry;
  const { answers } = method;
  const fitted = answers.way === "fitter" ? { fitted: { method: answers.fitter, parameters: {}, seed: 1 } } : {};
  return {
    model: { name, points, truth, origin: originOf(set, name), ...(inputs !== undefined && { inputs }) },
    claim: { model: place, method: answers.called, predicted, typeErrors, ...(submission !== undefined && { submission }), ...fitted, mean: entry[protocol] },
  };
}

/** Public models are fetched by whoever opens the link; worse scans of them are made by `fit4cad degrade`. */
function originOf({ part, degraded }: ModelSet, name: string): SharedOrigin {
  const number = Number(name.replace(/^PC/, ""));
  return degraded || !Number.isInteger(number) ? { kind: "files" } : { kind: "public", model: { set: part, number } };
}

function printOf(hashes: Entry["inputs"]): ReturnType<typeof fingerprint> {
  const each = Object.entries(hashes).flatMap(([role, of]) => [of].flat().map((sha256) => ({ path: role, role: role as HashedFile["role"], sha256 })));
  return fingerprint(each);
}
