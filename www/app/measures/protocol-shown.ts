// Whether the sheet on the two protocols is open, and the way from it to all others.

import { signal } from "@preact/signals";
import { goToPanel } from "../state/panels";
import { goTo, HOME } from "../state/router";

export const protocolShown = signal(false);

/** Shows the submissions by every protocol. */
export function compareAll(): void {
  protocolShown.value = false;
  goTo(HOME);
  goToPanel("field");
}
