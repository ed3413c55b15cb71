// Keeping a case: as files, as a link, and on the page that scores and fits.

import type { JSX } from "preact";
import { computed } from "@preact/signals";
import { copy, download } from "../export/download";
import { safe } from "../export/submission";
import { zip } from "../export/zip";
import { goToPanel } from "../shell/panels";
import { goTo, HOME } from "../shell/router";
import { addMade } from "../state/inbox";
import { notify } from "../state/notices";
import type { ModelFile } from "../../worker/protocol";
import { isGenerated } from "./case";
import { writeCase } from "./link/link";
import { ask, current, failure, made, making } from "./state";

const link = computed<{ readonly address: string } | { readonly why: string }>(() => {
  if (!isGenerated(current.value)) return { why: "A link can hold what is generated. This case is made of files: save them instead." };
  try {
    return { address: `${location.origin}${location.pathname}?page=studio${writeCase(current.value)}` };
  } catch (error) {
    return { why: error instanceof Error ? error.message : String(error) };
  }
});

export function SaveSection(): JSX.Element {
  const holdsPoints = (made.value?.result.positions.length ?? 0) > 0;
  const ready = holdsPoints && !making.value && failure.value === undefined;
  const kept = link.value;
  return (
    <section aria-labelledby="studio-keep">
      <h3 id="studio-keep">Keep and use</h3>
      <div class="row">
        <button type="button" class="primary" disabled={!ready} onClick={() => void attempt(handOver)}>
          Score and fit it
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
async function filesOf(name: string): Promise<ModelFile[]> {
  const { cloud, truth } = await ask((engine) => engine.texts());
  const file = (role: ModelFile["role"], path: string, text: string): ModelFile => ({
    path,
    role,
    data: new Blob([text], { type: "text/plain" }),
  });
  return [
    file("cloud", `${name}.txt`, cloud),
    ...(truth
      ? (["primitives", "parametric", "implicit"] as const).map((role) => file(role, `${name}_${role}.txt`, truth[role]))
      : []),
  ];
}

async function save(): Promise<void> {
  const name = safe(current.value.name);
  download(`${name}.zip`, await zip(await filesOf(name)));
}

async function handOver(): Promise<void> {
  const name = safe(current.value.name);
  const called = addMade(name, { kind: "files" }, await filesOf(name), "shown");
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
