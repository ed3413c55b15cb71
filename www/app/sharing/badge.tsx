// How the claims of the link stand, beside the panel's title.

import type { JSX } from "preact";
import { judged, tally } from "./opened";
import { Icon } from "../ui/icon";

export function sharedBadge(): JSX.Element | null {
  const { verified, differs } = tally.value;
  const all = judged.value.length;
  if (differs > 0) {
    return (
      <span class="badge error">
        {differs}
        <span class="visually-hidden"> differ</span>
      </span>
    );
  }
  return all > 0 && verified === all ? (
    <span class="badge good">
      <Icon name="check" />
      <span class="visually-hidden">verified here</span>
    </span>
  ) : null;
}
