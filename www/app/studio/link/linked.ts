// A case as a link has it.

import type { Case } from "../case";

export interface LinkedCase {
  readonly of: Case;
  /** Version of the engine it was made with; links of version 1 do not say. */
  readonly engine?: string;
}
