// What was done, step by step, so that it can be undone and done again. Nothing here knows what
// the states are.

export interface Step<State> {
  readonly state: State;
  /** What was done to come to the state; empty at the beginning. */
  readonly name: string;
  /** Steps in succession with the same are one: the many values a field goes through. */
  readonly merge?: string;
}

export interface History<State> {
  /** Earliest first. */
  readonly past: readonly Step<State>[];
  readonly present: Step<State>;
  /** Next first. */
  readonly future: readonly Step<State>[];
}

/** States share what they have in common, so that many cost little. */
const LONGEST = 500;

export function begin<State>(state: State): History<State> {
  return { past: [], present: { state, name: "" }, future: [] };
}

/** The history with a step more. What had been undone is forgotten. */
export function advance<State>(history: History<State>, next: Step<State>): History<State> {
  const { past, present, future } = history;
  const same = next.merge !== undefined && next.merge === present.merge && future.length === 0;
  return { past: same ? past : [...past, present].slice(-LONGEST), present: next, future: [] };
}

export function undo<State>(history: History<State>): History<State> {
  const { past, present, future } = history;
  const last = past.at(-1);
  return last ? { past: past.slice(0, -1), present: last, future: [present, ...future] } : history;
}

export function redo<State>(history: History<State>): History<State> {
  const { past, present, future } = history;
  const [next, ...rest] = future;
  return next ? { past: [...past, present], present: next, future: rest } : history;
}
