// A submission that the page fitted: method, seed and parameters, by which it is fitted again.

import type { FitRequest } from "../../../worker/protocol";
import type { Page } from "./page";

/** A fit for a model on the page. */
export interface Asked {
  readonly model: string;
  readonly request: FitRequest;
}

export function collect(model: string, method: string, page: Pick<Page, "fitOf">): FitRequest | undefined {
  return page.fitOf(model, method);
}

/**
 * Fits again. Fits of one model are to be in the order in which they got their names. Gives why each
 * failed, where it did, and nothing where other fits are under way.
 */
export async function rebuild(asked: readonly Asked[], page: Page, stopped: AbortSignal): Promise<readonly (string | undefined)[] | undefined> {
  return asked.length === 0 || stopped.aborted ? [] : page.fit(asked, stopped);
}
