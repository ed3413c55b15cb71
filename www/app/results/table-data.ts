// The standing table: its sets, its methods, and what they scored.

import standing from "../../../results/sets.toml";
import type { Method } from "../../shared/results/method.mjs";
import type { Scores, SetScores, Summary } from "../../shared/results/scores.mjs";
import type { ModelSet } from "../../shared/results/sets.mjs";

/** What the table shows of a set: neither single models nor types nor sizes. */
export type Sum = Omit<SetScores, "models" | "summary"> & { readonly summary: Omit<Summary, "types" | "sizes"> };

export interface Row {
  readonly id: string;
  readonly method: Method;
  readonly sums: readonly Sum[];
}

const METHODS = import.meta.glob<Method>("../../../results/*/method.toml", { eager: true, import: "default" });
const SUMS = import.meta.glob<readonly Sum[]>("../../../results/*/scores.json", { eager: true, import: "default", query: "?summary" });
const SCORES = import.meta.glob<Scores>("../../../results/*/scores.json", { import: "default" });

export const SETS: readonly ModelSet[] = standing.sets;

/** By the name of the folder, which stands in addresses. */
export const ROWS: readonly Row[] = Object.entries(METHODS).map(([path, method]) => ({
  id: path.split("/").at(-2) ?? path,
  method,
  sums: SUMS[path.replace(/method\.toml$/, "scores.json")] ?? [],
}));

export function rowOf(id: string | undefined): Row | undefined {
  return ROWS.find((row) => row.id === id);
}

export function setOf(id: string): ModelSet | undefined {
  return SETS.find((set) => set.id === id);
}

export function summaryOf({ sums }: Row, set: string): Sum["summary"] | undefined {
  return sums.find((sum) => sum.set === set)?.summary;
}

const asked = new Map<string, Promise<Scores>>();

/** All that a method scored, model by model; fetched when first asked for, and again where that failed. */
export function scoresOf(id: string): Promise<Scores> {
  let answer = asked.get(id);
  if (!answer) {
    const load = SCORES[`../../../results/${id}/scores.json`];
    answer = load ? load() : Promise.reject(new Error(`there is no method ${id} in the table`));
    answer.catch(() => asked.delete(id));
    asked.set(id, answer);
  }
  return answer;
}
