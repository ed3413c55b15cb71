// This page, as the kinds of content see it.

import { downloadModels } from "../public/download";
import { publicBase } from "../public/source";
import { makeSample } from "../samples/samples";
import { fitModels, tallyOf, tellTally } from "../state/fitting";
import { fitOf } from "../state/made";
import { models } from "../state/models";
import { notify } from "../state/notices";
import { plural } from "../ui/format";
import type { Page } from "./kinds/page";

export const thisPage: Page = {
  models: () => models.value,
  fitOf,
  makeSample,
  async download(wanted, stopped) {
    const base = publicBase();
    return base.kind === "refused" ? "short" : downloadModels(base.address, wanted, stopped);
  },
  async fit(jobs, stopped) {
    const run = await fitModels(jobs, { signal: stopped, quiet: true });
    if (!run) {
      notify("The fits of the link were not repeated: another fit is under way.");
      return undefined;
    }
    const tally = tallyOf(run);
    const count = plural(jobs.length, "fit");
    tellTally(`${tally.done === jobs.length ? count : `${tally.done} of ${count}`} of the link repeated here`, tally);
    return run.fits.map((fit) => {
      const state = fit.state.peek();
      return state.kind === "failed" ? state.message : undefined;
    });
  },
};
