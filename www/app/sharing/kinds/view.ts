// What the sharer looked at: told by places in the link, and looked at again as far as it is here.

import type { Report } from "../../engine/contract";
import type { PrimitiveRef } from "../../state/selection";
import type { CameraState } from "../../view/types";
import type { MethodReports } from "../../../worker/protocol";
import type { SharedView } from "../shared";

/** What is looked at, by names as the page has them. */
export interface Look {
  readonly model: string;
  readonly method?: string;
  /** The submission in the left view, where it is not the truth that is there. */
  readonly left?: string;
  readonly rightIsTruth?: true;
  readonly primitive?: PrimitiveRef;
  readonly camera?: CameraState;
  readonly colour?: string;
  readonly arrangement?: string;
}

/** Nothing where the model is not among those of the link, here by their names. */
export function collect({ model, ...rest }: Look, models: readonly string[]): SharedView | undefined {
  const place = models.indexOf(model);
  return place < 0 ? undefined : { ...rest, model: place };
}

/** What there is to look at of it, on a model with these submissions. A link may name any. */
export function rebuild({ model: _, method, left, primitive, ...rest }: SharedView, model: string, reports: readonly MethodReports[]): Look {
  const of = (name: string | undefined) => reports.find((own) => own.method === name)?.definition;
  const [report, beside] = [of(method), of(left)];
  return {
    model,
    ...rest,
    ...(report && { method: report.method }),
    ...(beside && { left: beside.method }),
    ...(primitive && isIn(primitive, report, beside) && { primitive }),
  };
}

function isIn({ side, index }: PrimitiveRef, report: Report | undefined, left: Report | undefined): boolean {
  const primitives = { truth: report?.primitives, prediction: report?.predictions, rival: left?.predictions }[side];
  return index < (primitives?.length ?? 0);
}
