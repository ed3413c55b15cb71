// How the claims of the link stand, beside the panel's title.

import type { JSX } from "preact";
import { Icon } from "../ui/icon";
import { standing } from "./state";

export function sharedBadge(): JSX.Element | null {
  const { all, verified, differs } = standing.value;
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
