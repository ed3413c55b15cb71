// What can be done about files that belong to no model: a way on, in place of a hint alone.

import type { JSX } from "preact";
import type { Recognised } from "../engine/contract";
import { SETS } from "../public/catalogue";
import { download, downloadModels } from "../public/download";
import { publicBase } from "../public/source";
import { brought, overrides, override, unplaced } from "../state/inbox";
import { models } from "../state/models";
import { notify } from "../state/notices";
import { goToPanel } from "../state/panels";

/** Those of the benchmark. */
const PUBLIC = /^PC([1-9]\d{0,2})$/i;
/** More would not be read. */
const CHOICES_AT_MOST = 500;

/** A file with what the engine took it for. */
type Known = readonly [path: string, what: Recognised];

export function Ways({ paths }: { paths: readonly string[] }): JSX.Element | null {
  const here = new Set(paths.filter((path) => brought.value.has(path)));
  if (here.size === 0) return null;
  const known = unplaced.value.flatMap(({ path, recognised }): Known[] => (recognised && here.has(path) ? [[path, recognised]] : []));
  const asked = known[0]?.[1].model ?? "";
  const number = Number(PUBLIC.exec(asked)?.[1] ?? Number.NaN);
  const sets = SETS.filter(({ count }) => number <= count && known.every(([, { model }]) => model === asked));
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

function UseFor({ known }: { known: readonly Known[] }): JSX.Element {
  const use = (model: string) => {
    for (const [path, { method }] of known) override(path, { ...overrides.peek()[path], model, method });
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
