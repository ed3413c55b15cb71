// The surface files with wrong vectors replaced, as one zip.

import { computed } from "@preact/signals";
import { download } from "../export/download";
import { engineVersion } from "../export/results";
import { zip } from "../export/zip";
import { notify } from "../state/notices";
import type { ZipEntry } from "../../worker/zip";
import { audited } from "./state";

interface CorrectedModel {
  readonly id: string;
  readonly vectors: number;
  readonly files: readonly ZipEntry[];
}

/** The models of which a vector was wrong and another told what is right. */
export const corrected = computed<readonly CorrectedModel[]>(() =>
  audited.value.flatMap(({ entry: { id }, outcome }) => {
    if (outcome?.kind !== "answered" || outcome.answer.corrections.length === 0) return [];
    const { corrections, corrected: files } = outcome.answer;
    return [{ id, vectors: corrections.length, files }];
  }),
);

/** Saves the corrected files, with a list of what was replaced. */
export async function saveCorrected(): Promise<void> {
  const lines = audited.value.flatMap(({ entry: { id }, outcome }) =>
    outcome?.kind === "answered"
      ? outcome.answer.corrections.map(
          ({ primitive, form, from }) => `${id}, primitive ${primitive}: ${form} form converted from the ${from} form`,
        )
      : [],
  );
  try {
    const about = `Corrected by Fit4CAD engine ${await engineVersion()}.`;
    const note = { path: "corrections.txt", data: new Blob([`${[about, ...lines].join("\n")}\n`], { type: "text/plain" }) };
    download("corrected.zip", await zip([...corrected.value.flatMap(({ files }) => files), note]));
  } catch (error) {
    notify(error instanceof Error ? error.message : String(error), "error");
  }
}
