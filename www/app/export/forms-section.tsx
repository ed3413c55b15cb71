// The primitives of the model on show in forms that other programs read, with or without a truth.

import type { JSX } from "preact";
import { useSignal } from "@preact/signals";
import { EXPORTS } from "../../generated/declared/exports.js";
import { STEP_FORM, TYPE_COLOURS, absence } from "../../shared/step.mjs";
import { sentence } from "../../shared/text.mjs";
import type { ModelSource } from "../../worker/protocol";
import { engine } from "../engine/client";
import { stepWorker } from "../engine/step";
import { isFitted, modelById, type ModelEntry } from "../state/models";
import { notify } from "../state/notices";
import { selectedMethod, selectedModel } from "../state/selection";
import { download } from "./download";

const TRUTH = "truth";

/** What a model's points are put together to: its methods, then the truth. */
export function segmentationsOf(entry: ModelEntry | undefined): readonly string[] {
  if (entry?.status.kind !== "scored") return [];
  const { methods, hasTruth } = entry.status.result.info;
  return [...methods, ...(hasTruth ? [TRUTH] : [])];
}

type Form = Pick<(typeof EXPORTS)[number], "name" | "ending" | "title" | "meaning">;

const FORMS: readonly Form[] = [...EXPORTS, STEP_FORM];

async function contentOf(source: ModelSource, method: string | undefined, form: string): Promise<Blob> {
  if (form !== STEP_FORM.name) return engine.run((api) => api.export(source, method, form));
  const texts = await engine.run((api) => api.texts(source, method));
  const worker = stepWorker();
  try {
    const { text, leftOut } = await worker.api.write(source.name, texts, TYPE_COLOURS);
    if (leftOut > 0) notify(sentence(absence(leftOut)));
    return new Blob([text]);
  } finally {
    worker.end();
  }
}

export function FormsSection(): JSX.Element | null {
  const busy = useSignal(false);
  const chosen = useSignal<string | undefined>(undefined);
  const entry = modelById(selectedModel.value);
  const all = segmentationsOf(entry);
  const whose = all.find((name) => name === chosen.value) ?? selectedMethod.value ?? all[0];
  if (!entry || whose === undefined) return null;

  const save = async ({ name, ending, title }: Form) => {
    busy.value = true;
    try {
      const method = whose === TRUTH ? undefined : whose;
      const content = await contentOf(entry.source, method, name);
      download(`${entry.id}_${whose}${ending}`, content);
    } catch (error) {
      notify(`${title} could not be written: ${error instanceof Error ? error.message : String(error)}`, "error");
    } finally {
      busy.value = false;
    }
  };

  return (
    <section>
      <h3>For other programs</h3>
      <p>
        <label>
          The primitives of {entry.id} by{" "}
          <select value={whose} onChange={(event) => (chosen.value = event.currentTarget.value)}>
            {all.map((name) => (
              <option key={name} value={name}>
                {name}
              </option>
            ))}
          </select>
        </label>
        {isFitted(entry, whose === TRUTH ? undefined : whose) && " Its surfaces were fitted here to the segments that were given."}
      </p>
      <ul class="exports">
        {FORMS.map((form) => (
          <li key={form.name}>
            <span>
              <strong>{form.title}</strong> {form.meaning}
            </span>
            <button type="button" disabled={busy.value} aria-label={`Save ${form.title}`} onClick={() => void save(form)}>
              Save
            </button>
          </li>
        ))}
      </ul>
    </section>
  );
}
