// Where models come from.

import type { ImportReport } from "../../generated/cad/cad.js";
import type { HowImported } from "../../worker/step";
import type { SampleOptions } from "../engine/contract";

export type SetName = "training" | "test";

/** One of the public models. */
export interface PublicModel {
  readonly set: SetName;
  readonly number: number;
}

/** Where a model came from; a sample can be made again, a public model fetched again, from this alone. */
export type Origin =
  | { readonly kind: "files" }
  | { readonly kind: "public"; readonly model: PublicModel }
  | { readonly kind: "sample"; readonly part: string; readonly options: SampleOptions };

/** The STEP file that a cloud was made of, and what became of its faces. */
export interface StepSource extends HowImported {
  /** As it was dropped. */
  readonly path: string;
  readonly data: Blob;
  readonly report: ImportReport;
}
