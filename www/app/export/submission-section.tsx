// A submission's files, to be handed in or scored elsewhere.

import type { JSX } from "preact";
import { useSignal } from "@preact/signals";
import { modelById, models, type ModelEntry } from "../state/models";
import { notify } from "../state/notices";
import { selectedMethod, selectedModel } from "../state/selection";
import { protocol } from "../state/settings";
import { plural } from "../ui/format";
import { download } from "./download";
import { zipSubmission } from "./submission";

function holds(entry: ModelEntry, method: string): boolean {
  return entry.status.kind === "scored" && entry.status.result.info.methods.includes(method);
}

export function SubmissionSection(): JSX.Element | null {
  const busy = useSignal(false);
  const method = selectedMethod.value;
  const entry = modelById(selectedModel.value);
  if (!entry || method === undefined) return null;
  const all = models.value.filter((candidate) => holds(candidate, method));

  const save = async (entries: readonly ModelEntry[], name: string) => {
    busy.value = true;
    try {
      download(`${name}.zip`, await zipSubmission(entries, method, protocol.value));
    } catch (error) {
      notify(`The zip could not be made: ${error instanceof Error ? error.message : String(error)}`, "error");
    } finally {
      busy.value = false;
    }
  };

  return (
    <section>
      <h3>The submission {method}</h3>
      <p>
        Its primitives, parametric and implicit files as a zip, in folders named as in the public test set. Your own
        files go in unchanged.
      </p>
      <div class="row">
        <button type="button" disabled={busy.value} onClick={() => void save([entry], `${entry.id}-${method}`)}>
          Save {entry.id}
        </button>
        {all.length > 1 && (
          <button type="button" disabled={busy.value} onClick={() => void save(all, method)}>
            Save {plural(all.length, "model")}
          </button>
        )}
      </div>
    </section>
  );
}
