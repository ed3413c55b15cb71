// What can be done about files that belong to no model: a way on, in place of a hint alone.

import type { JSX } from "preact";
import { SEGMENTATION } from "../../shared/roles.mjs";
import { SETS } from "../public/catalogue";
import { download, downloadModels } from "../public/download";
import { publicBase } from "../public/source";
import { brought, overrides, override } from "../state/inbox";
import { models } from "../state/models";
import { notify } from "../state/notices";
import { goToPanel } from "../state/panels";

/** `PC5_primitives.txt`, `PC5_primitives_HT.txt`: of which model, and by whom. */
const NAMED = new RegExp(`^(.+?)[_-](?:${SEGMENTATION.join("|")})(?:[_-](.+))?\\.\\w+$`, "i");
/** Those of the benchmark. */
const PUBLIC = /^PC([1-9]\d{0,2})$/i;
/** What a submission is called whose files do not say. */
const NAMELESS = "submission";
/** More would not be read. */
const CHOICES_AT_MOST = 500;

interface Recognised {
  readonly path: string;
  readonly model: string;
  readonly method: string;
}

/** The files among these that say by their names that they hold primitives or surfaces of some model. */
function recognised(paths: readonly string[]): readonly Recognised[] {
  return paths.flatMap((path) => {
    const parts = path.split(/[/\\]/);
    const [, model, method] = NAMED.exec(parts.at(-1) ?? "") ?? [];
    return model === undefined ? [] : [{ path, model, method: method ?? parts.at(-2) ?? NAMELESS }];
  });
}

export function Ways({ paths }: { paths: readonly string[] }): JSX.Element | null {
  const here = paths.filter((path) => brought.value.has(path));
  if (here.length === 0) return null;
  const known = recognised(here);
  const number = Number(PUBLIC.exec(known[0]?.model ?? "")?.[1] ?? Number.NaN);
  const sets = SETS.filter(({ count }) => number <= count && known.every(({ model }) => model === known[0]?.model));
  return (
    <p class="ways">
      <button type="button" onClick={() => goToPanel("files")}>
        Say what it is under Files
      </button>
      {sets.map(({ name, title }) => (
        <button key={name} type="button" disabled={download.value !== undefined} onClick={() => void fetchCloud(name, number)}>
          Get PC{number} of the {title.toLowerCase()}
        </button>
      ))}
      {known.length > 0 && models.value.length > 0 && <UseFor known={known} />}
    </p>
  );
}

function UseFor({ known }: { known: readonly Recognised[] }): JSX.Element {
  const use = (model: string) => {
    for (const { path, method } of known) override(path, { ...overrides.peek()[path], model, method });
  };
  return (
    <label>
      These are primitives: use {known.length > 1 ? "them" : "it"} as a submission for{" "}
      <select value="" onChange={(event) => use(event.currentTarget.value)}>
        <option value="" disabled>
          …
        </option>
        {models.value.slice(0, CHOICES_AT_MOST).map(({ id }) => (
          <option key={id} value={id}>
            {id}
          </option>
        ))}
      </select>
    </label>
  );
}

async function fetchCloud(set: (typeof SETS)[number]["name"], number: number): Promise<void> {
  const base = publicBase();
  if (base.kind === "refused") notify(base.reason, "error");
  else await downloadModels(base.address, { set, numbers: [number], withResults: false });
}
