// Figures against figures: differences, wins and losses, means over the same models.

/** The published figures are rounded to six digits: a difference below half of the last is none. */
const EVEN = 5e-7;

export type Outcome = "better" | "worse" | "even";

export interface Pair {
  readonly own: number | null;
  readonly theirs: number | null;
}

/** Own minus theirs; null where either is missing. */
export function difference({ own, theirs }: Pair): number | null {
  return own === null || theirs === null ? null : own - theirs;
}

export function outcome(pair: Pair, good: "higher" | "lower"): Outcome | null {
  const by = difference(pair);
  if (by === null) return null;
  // Room for the rounding of the subtraction itself.
  if (Math.abs(by) <= EVEN + 1e-12) return "even";
  return by > 0 === (good === "higher") ? "better" : "worse";
}

export interface Tally {
  readonly better: number;
  readonly worse: number;
  readonly even: number;
}

export function tally(pairs: readonly Pair[], good: "higher" | "lower"): Tally {
  const counts = { better: 0, worse: 0, even: 0 };
  for (const pair of pairs) {
    const result = outcome(pair, good);
    if (result) counts[result] += 1;
  }
  return counts;
}

/** The means over the models where both sides have a figure, so that like is compared with like. */
export function means(pairs: readonly Pair[]): Pair {
  const both = pairs.filter((pair): pair is { own: number; theirs: number } => difference(pair) !== null);
  if (both.length === 0) return { own: null, theirs: null };
  const mean = (side: "own" | "theirs") => both.reduce((sum, pair) => sum + pair[side], 0) / both.length;
  return { own: mean("own"), theirs: mean("theirs") };
}
