// The surface files with wrong vectors replaced, as one zip.

import { computed } from "@preact/signals";
import { download } from "../export/download";
import { safe } from "../export/submission";
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
    const answer = outcome?.kind === "answered" ? outcome.answer.corrected : undefined;
    if (!answer || answer.corrections.length === 0) return [];
    // A model's name may hold the folder that tells it from its namesake.
    const name = id.split("/").map(safe).join("/");
    const files = (["parametric", "implicit"] as const).flatMap((form) => {
      const text = answer[form];
      return text === undefined ? [] : [{ path: `${name}_${form}.txt`, data: new Blob([text], { type: "text/plain" }) }];
    });
    return [{ id, vectors: answer.corrections.length, files }];
  }),
);

/** Saves the corrected files, with a list of what was replaced. */
export async function saveCorrected(): Promise<void> {
  const lines = audited.value.flatMap(({ entry: { id }, outcome }) =>
    outcome?.kind === "answered"
      ? (outcome.answer.corrected?.corrections ?? []).map(
          ({ primitive, form, from }) => `${id}, primitive ${primitive}: ${form} form converted from the ${from} form`,
        )
      : [],
  );
  const note = { path: "corrections.txt", data: new Blob([`${lines.join("\n")}\n`], { type: "text/plain" }) };
  try {
    download("corrected.zip", await zip([...corrected.value.flatMap(({ files }) => files), note]));
  } catch (error) {
    notify(error instanceof Error ? error.message : String(error), "error");
  }
}
