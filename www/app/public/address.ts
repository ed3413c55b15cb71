// `?data=…`: a zip that the page opens by its address.

import { unplaced, type Unplaced } from "../state/inbox";
import { models } from "../state/models";
import { notify } from "../state/notices";
import { downloadZip, fileName, shortfall } from "./download";
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
  if (checked.kind === "refused") {
    tell(checked.reason, []);
    return;
  }
  // What did not arrive is told already.
  if ((await downloadZip(checked.address)) === "complete") tellWhatItHolds(fileName(checked.address));
}

/** Says so where a zip that arrived holds no model, and why. */
function tellWhatItHolds(zip: string): void {
  const isOfZip = (path: string) => path === zip || path.startsWith(`${zip}/`);
  if (models.value.some(({ source }) => source.files.some(({ path }) => isOfZip(path)))) return;
  const lacking = unplaced.value.filter(({ path }) => isOfZip(path));
  const [first] = lacking;
  const more = lacking.length > 1 ? ` And ${lacking.length - 1} more of its files found no place.` : "";
  const why = first ? `${first.path === zip ? "" : `${first.path}: `}${first.reason}${more}` : "There is no file in it.";
  tell(`“${zip}” gave no model. ${why}`, lacking);
}

function tell(summary: string, files: readonly Unplaced[]): void {
  shortfall.value = { summary, files };
  notify(summary, "error");
}
