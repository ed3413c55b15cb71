// Has the models of a link again without their files: samples are made, public models downloaded,
// fits repeated.

import { signal } from "@preact/signals";
import { downloadModels } from "../public/download";
import { publicBase } from "../public/source";
import { SETS, type PublicModel } from "../public/catalogue";
import { makeSample } from "../samples/samples";
import { fitModels } from "../state/fitting";
import { models, type ModelEntry } from "../state/models";
import type { Claim, SharedModel, SharedOrigin, SharedResults } from "./shared";

/** The public repository has results of these for the test set. */
const PUBLISHED: readonly string[] = ["HT", "PG"];

/** Whether a model can be had again from what the link says of it. */
export function isRebuildable({ origin }: SharedModel): boolean {
  return origin.kind === "sample" || (origin.kind === "public" && origin.model !== undefined);
}

/** The model on the page that a link speaks of. */
export function entryOf({ origin, name }: SharedModel): ModelEntry | undefined {
  const byOrigin = origin.kind === "files" ? undefined : models.value.find((entry) => isSame(entry.origin, origin));
  return byOrigin ?? models.value.find(({ id }) => id === name);
}

function isSame(a: SharedOrigin, b: SharedOrigin): boolean {
  if (a.kind === "sample" && b.kind === "sample") {
    const options = new Set([...Object.keys(a.options), ...Object.keys(b.options)]) as Set<keyof typeof a.options>;
    return a.part === b.part && [...options].every((option) => a.options[option] === b.options[option]);
  }
  if (a.kind !== "public" || b.kind !== "public") return false;
  return a.model !== undefined && a.model.set === b.model?.set && a.model.number === b.model.number;
}

/** What having some of the models again takes. */
export interface Work {
  readonly samples: number;
  readonly downloads: number;
  readonly fits: number;
}

export function workOf({ models: shared, claims }: SharedResults, places: readonly number[]): Work {
  const absent = absentAmong(shared, places);
  const of = (kind: SharedOrigin["kind"]) => absent.filter((place) => shared[place]?.origin.kind === kind).length;
  const fits = claims.filter(({ model, fitted }) => fitted && places.includes(model)).length;
  return { samples: of("sample"), downloads: of("public"), fits };
}

function absentAmong(shared: readonly SharedModel[], places: readonly number[]): number[] {
  return places.filter((place) => {
    const model = shared[place];
    return model !== undefined && entryOf(model) === undefined;
  });
}

/** Whether models are being had again just now. */
export const rebuilding = signal(false);

/**
 * Has the models at these places again that are not here, and then their fits. What fails is told by its own part of
 * the page. Samples made quietly do not come into view.
 */
export async function rebuild(results: SharedResults, places: readonly number[], how: "shown" | "quiet" = "shown"): Promise<void> {
  if (places.length === 0) return;
  rebuilding.value = true;
  try {
    const absent = absentAmong(results.models, places);
    for (const place of absent) {
      const origin = results.models[place]?.origin;
      if (origin?.kind === "sample") await makeSample(origin.part, origin.options, how);
    }
    await fetchAgain(results, absent);
    await fitAgain(results.models, results.claims.filter(({ model }) => places.includes(model)));
  } finally {
    rebuilding.value = false;
  }
}

async function fetchAgain({ models: shared, claims }: SharedResults, places: readonly number[]): Promise<void> {
  const base = publicBase();
  if (base.kind === "refused") return;
  for (const { name: set } of SETS) {
    for (const withResults of [false, true]) {
      const numbers = places.flatMap((place) => {
        const model = publicModelOf(shared[place]);
        const published = claims.some((claim) => claim.model === place && isPublished(claim));
        return model?.set === set && published === withResults ? [model.number] : [];
      });
      if (numbers.length > 0) await downloadModels(base.address, { set, numbers, withResults });
    }
  }
}

function publicModelOf(model: SharedModel | undefined): PublicModel | undefined {
  return model?.origin.kind === "public" ? model.origin.model : undefined;
}

function isPublished({ method, fitted }: Claim): boolean {
  return fitted === undefined && PUBLISHED.includes(method);
}

/** Models that were fitted alike are fitted together. */
async function fitAgain(shared: readonly SharedModel[], claims: readonly Claim[]): Promise<void> {
  const ways = new Set(claims.map(({ fitted }) => fitted).filter((fitted) => fitted !== undefined));
  for (const request of ways) {
    const entries = claims.flatMap(({ model, fitted }) => {
      const named = fitted === request ? shared[model] : undefined;
      return (named && entryOf(named)) ?? [];
    });
    await fitModels(entries, request);
  }
}
