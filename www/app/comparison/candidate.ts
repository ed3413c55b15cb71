// What the panel compares.

import type { Match } from "../../shared/published/match.mjs";
import type { Report } from "../engine/contract";
import type { ModelEntry } from "../state/models";

/** A model on the page, scored, and what it is. */
export interface Candidate {
  readonly entry: ModelEntry;
  readonly report: Report;
  readonly match: Match;
}
