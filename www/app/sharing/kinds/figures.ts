// The figures of a submission: told with all their digits, and compared to the last bit. They are the
// one kind of content that is never had again from a link: what is made of them here is the judgement.

import { MEASURES } from "../../measures/measures";
import type { Measure, Report } from "../../engine/contract";
import type { Claim, SharedModel } from "../shared";

export type Figure = Measure | "points" | "truth" | "predicted" | "type errors";

export interface Difference {
  readonly figure: Figure;
  readonly claimed: number | null;
  readonly found: number | null;
}

export interface Figures {
  readonly model: Pick<SharedModel, "points" | "truth">;
  readonly claim: Pick<Claim, "predicted" | "typeErrors" | "mean">;
}

export function collect({ points, truth, predicted, type_errors: typeErrors, mean }: Report): Figures {
  return { model: { points, truth }, claim: { predicted, typeErrors, mean } };
}

/** Every claimed figure that is not the report's; none of those that were collected from it. */
export function compare({ model, claim }: Figures, report: Report): Difference[] {
  const figures: Difference[] = [
    { figure: "points", claimed: model.points, found: report.points },
    { figure: "truth", claimed: model.truth, found: report.truth },
    { figure: "predicted", claimed: claim.predicted, found: report.predicted },
    ...MEASURES.flatMap((measure): Difference[] => {
      const claimed = claim.mean[measure];
      // One that the link's version does not know is not claimed.
      return claimed === undefined ? [] : [{ figure: measure, claimed, found: report.mean[measure] }];
    }),
    { figure: "type errors", claimed: claim.typeErrors, found: report.type_errors },
  ];
  return figures.filter(({ claimed, found }) => !Object.is(claimed, found));
}
