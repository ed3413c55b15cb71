// `?data=…`: a zip that the page opens by its address.

import { notify } from "../state/notices";
import { downloadZip, shortfall } from "./download";
import { checkZip } from "./source";

/** The zip that the page's address names, as it names it. */
export function dataAsked(): string | undefined {
  return new URLSearchParams(location.search).get("data") ?? undefined;
}

/** Opens the zip that the page's address names, if it names one. */
export async function openData(): Promise<void> {
  const asked = dataAsked();
  if (asked === undefined) return;
  const checked = checkZip(asked);
  if (checked.kind === "address") {
    await downloadZip(checked.address);
  } else {
    shortfall.value = { summary: checked.reason, files: [] };
    notify(checked.reason, "error");
  }
}
