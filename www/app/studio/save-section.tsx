// Keeping a case: as files, as a link, and on the page that scores and fits.

import type { JSX } from "preact";
import { computed } from "@preact/signals";
import { copy, download } from "../export/download";
import { zip } from "../export/zip";
import { goToPanel } from "../state/panels";
import { goTo, HOME } from "../state/router";
import { addMade } from "../state/arrivals";
import { notify } from "../state/notices";
import type { CaseFiles } from "../../worker/studio";
import { isGenerated } from "./case";
import { writeCase } from "./link/link";
import { ask, current, engineHere, failure, made, making, offered } from "./state";

const link = computed<{ readonly address: string } | { readonly why: string }>(() => {
  if (!isGenerated(current.value)) return { why: "A link can hold what is generated. This case is made of files: save them instead." };
  try {
    const engine = engineHere.value;
    const fragment = writeCase({ of: current.value, ...(engine !== undefined && { engine }) });
    return { address: `${location.origin}${location.pathname}?page=studio${fragment}` };
  } catch (error) {
    return { why: error instanceof Error ? error.message : String(error) };
  }
});

export function SaveSection(): JSX.Element {
  const holdsPoints = (made.value?.result.positions.length ?? 0) > 0;
  const ready = holdsPoints && !making.value && !offered.value && failure.value === undefined;
  const kept = link.value;
  return (
    <section aria-labelledby="studio-keep">
      <h3 id="studio-keep">Keep and use</h3>
      <div class="row">
        <button type="button" class="primary" disabled={!ready} onClick={() => void attempt(handOver)}>
          Open it under Score
        </button>
        <button type="button" disabled={!ready} onClick={() => void attempt(save)}>
          Save files
        </button>
        {"address" in kept && (
          <button type="button" onClick={() => void copy(kept.address, "Link")}>
            Copy link
          </button>
        )}
      </div>
      {"address" in kept ? (
        <label class="studio-link">
          <span>Link</span>
          <input type="text" readOnly value={kept.address} onFocus={(event) => event.currentTarget.select()} />
        </label>
      ) : (
        <p class="hint">{kept.why}</p>
      )}
    </section>
  );
}

/** The files of the case in the paper's form. */
function filesNow(): Promise<CaseFiles> {
  const { name } = current.value;
  return ask((engine) => engine.files(name));
}

async function save(): Promise<void> {
  const { name, files } = await filesNow();
  const note = { case: current.value.name, engine: engineHere.value };
  const about = new Blob([`${JSON.stringify(note, null, 2)}\n`], { type: "application/json" });
  download(`${name}.zip`, await zip([...files, { path: "fit4cad.json", data: about }]));
}

async function handOver(): Promise<void> {
  const { name, files } = await filesNow();
  const called = addMade(name, { kind: "files" }, files, "shown");
  goTo(HOME);
  goToPanel("fit");
  notify(`${called} is on the page: fit it with either method.`);
}

async function attempt(work: () => Promise<void>): Promise<void> {
  try {
    await work();
  } catch (error) {
    notify(error instanceof Error ? error.message : String(error), "error");
  }
}
