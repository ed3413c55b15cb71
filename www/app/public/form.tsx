// Choose public models by their numbers.

import type { JSX } from "preact";
import { useSignal } from "@preact/signals";
import { plural } from "../ui/format";
import type { SetName } from "../state/origin";
import { PUBLISHED_METHODS } from "../../shared/published/methods.mjs";
import { filesOf, readNumbers, SETS } from "./catalogue";
import { download, downloadModels, shortfall } from "./download";
import { DownloadProgress } from "./progress";
import { publicBase } from "./source";

export function PublicForm({ onTaken }: { onTaken: () => void }): JSX.Element {
  const chosen = useSignal<SetName>("test");
  const text = useSignal("1-5");
  const withResults = useSignal(true);
  const set = SETS.find(({ name }) => name === chosen.value) ?? SETS[0];
  const base = publicBase();
  if (!set || base.kind === "refused") return <p role="alert">{base.kind === "refused" && base.reason}</p>;

  const numbers = readNumbers(text.value, set);
  const wanted = numbers.kind === "numbers" ? { set: set.name, numbers: numbers.numbers, withResults: withResults.value } : undefined;
  const count = wanted ? wanted.numbers.length * filesOf(wanted.set, 1, wanted.withResults).length : 0;
  return (
    <form
      class="public"
      onSubmit={(event) => {
        event.preventDefault();
        if (!wanted) return;
        void downloadModels(base.address, wanted).then((ending) => {
          if (ending === "complete") onTaken();
        });
      }}
    >
      <p>
        The 225 models of the benchmark, from {base.address.host}, about a megabyte each. The page asks that host for
        the files of a model only when you press Download, or open a shared link that shows that model. Otherwise it
        uses the network for its own parts alone, and for the zip that <code>?data=</code> in its address names. It
        sends nothing: what you drop, choose or paste never leaves your machine.
      </p>
      <div class="row">
        <fieldset class="switch">
          <legend class="visually-hidden">Which set</legend>
          {SETS.map(({ name, title, count }) => (
            <label key={name}>
              <input type="radio" name="public-set" checked={name === chosen.value} onChange={() => (chosen.value = name)} />
              <span>
                {title} (1–{count})
              </span>
            </label>
          ))}
        </fieldset>
        <label class="which-numbers">
          Models
          <input
            type="text"
            value={text.value}
            placeholder="1-5, 9"
            spellcheck={false}
            autocomplete="off"
            aria-invalid={numbers.kind === "wrong"}
            aria-describedby="public-count"
            onInput={(event) => (text.value = event.currentTarget.value)}
          />
        </label>
        <button type="button" onClick={() => (text.value = `1-${set.count}`)}>
          All {set.count}
        </button>
      </div>
      {set.name === "test" && (
        <label class="check">
          <input
            type="checkbox"
            checked={withResults.value}
            onChange={(event) => (withResults.value = event.currentTarget.checked)}
          />
          With the published results of {PUBLISHED_METHODS.join(" and ")}
        </label>
      )}
      <div class="row">
        <button type="submit" disabled={!wanted || download.value !== undefined}>
          Download
        </button>
        <p id="public-count" role="status" class={numbers.kind === "wrong" ? "mark error" : "mark note"}>
          {numbers.kind === "wrong"
            ? numbers.reason
            : `${plural(numbers.numbers.length, "model")}, ${plural(count, "file")}`}
        </p>
      </div>
      <DownloadProgress id="download-here" />
      <Outcome />
    </form>
  );
}

function Outcome(): JSX.Element | null {
  const lack = shortfall.value;
  if (!lack) return null;
  return (
    <div class="outcome" role="status">
      <p>{lack.summary}</p>
      {lack.files.length > 0 && (
        <ul tabIndex={0} aria-label="Files that did not arrive">
          {lack.files.map(({ path, reason }) => (
            <li key={path}>
              <code>{path}</code> {reason}
            </li>
          ))}
        </ul>
      )}
    </div>
  );
}
