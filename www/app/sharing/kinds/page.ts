// What the page does for content to be told in a link, and to be had again from one. The kinds of
// content know no more of it; tests hand them a page of their own.

import type { SampleOptions } from "../../engine/contract";
import type { Ending, Wanted } from "../../public/download";
import type { FitJob } from "../../state/fitting";
import type { Entrance } from "../../state/arrivals";
import type { ModelEntry } from "../../state/models";
import type { FitRequest } from "../../../worker/protocol";

export interface Page {
  readonly models: () => readonly Pick<ModelEntry, "id" | "origin">[];
  /** How a submission was fitted on the page; nothing for one that was brought. */
  readonly fitOf: (model: string, method: string) => FitRequest | undefined;
  readonly makeSample: (part: string, options: SampleOptions, how: Entrance, stopped: AbortSignal) => Promise<void>;
  readonly download: (wanted: Wanted, stopped: AbortSignal) => Promise<Ending>;
  /** Of each fit why it failed, where it did; nothing at all where other fits are under way. */
  readonly fit: (jobs: readonly FitJob[], stopped: AbortSignal) => Promise<readonly (string | undefined)[] | undefined>;
}
