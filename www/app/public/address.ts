// `?data=…`: a zip that the page opens by its address.

import { notify } from "../state/notices";
import { downloadZip } from "./download";
import { checkZip } from "./source";

/** Opens the zip that the page's address names, if it names one. */
export async function openData(): Promise<void> {
  const asked = new URLSearchParams(location.search).get("data");
  if (asked === null) return;
  const checked = checkZip(asked);
  if (checked.kind === "refused") notify(checked.reason, "error");
  else await downloadZip(checked.address);
}
