// A link that holds the results themselves.

import type { JSX } from "preact";
import { useComputed, useSignal } from "@preact/signals";
import { useEffect, useId } from "preact/hooks";
import { copy } from "../export/download";
import { engineVersion } from "../export/results";
import { methods, scoredRows } from "../state/models";
import { selectedMethod } from "../state/selection";
import { protocol } from "../state/settings";
import { integer, plural } from "../ui/format";
import { collect } from "./collect";
import { writeFragment } from "./codec/link";
import { fingerprintsOf } from "./fingerprints";
import { looking } from "./looking";
import type { SharedResults } from "./shared";
import { thisPage } from "./this-page";

type Made =
  | { readonly kind: "making" }
  | { readonly kind: "made"; readonly fragment: string; readonly results: SharedResults }
  | { readonly kind: "failed"; readonly message: string };

export function LinkSection(): JSX.Element {
  const chosen = useSignal<ReadonlySet<string>>(new Set(methods.peek().filter((method) => method === selectedMethod.peek())));
  const made = useSignal<Made>({ kind: "making" });
  const rows = useComputed(() => scoredRows.value.filter(({ reports }) => chosen.value.has(reports.method)));
  const id = useId();

  useEffect(() => {
    let wanted = true;
    made.value = { kind: "making" };
    void make(rows.value).then((result) => {
      if (wanted) made.value = result;
    });
    return () => {
      wanted = false;
    };
  }, [rows.value, protocol.value]);

  const link = made.value.kind === "made" ? addressWith(made.value.fragment) : "";
  return (
    <section class="share-link">
      <h3>A link</h3>
      <p>
        The results are in the link itself; nothing is stored anywhere. Whoever opens it sees them marked “as claimed”,
        and can drop the same files to have every digit checked.
      </p>
      {methods.value.length > 1 && <Methods chosen={chosen} />}
      {made.value.kind === "failed" ? (
        <p role="alert" class="mark error">
          {made.value.message}
        </p>
      ) : (
        <>
          <div class="copied-line">
            <label class="visually-hidden" for={id}>
              Link
            </label>
            <input id={id} type="text" readOnly value={link} placeholder="Making the link…" onFocus={(event) => event.currentTarget.select()} />
            <button type="button" class="primary" disabled={!link} onClick={() => void copy(link, "Link")}>
              Copy link
            </button>
            <button type="button" disabled={!link} onClick={() => void copy(embedding(link), "Embedding code")}>
              Copy embedding
            </button>
          </div>
          {made.value.kind === "made" && <Contents results={made.value.results} length={link.length} />}
        </>
      )}
    </section>
  );
}

function Methods({ chosen }: { chosen: { value: ReadonlySet<string> } }): JSX.Element {
  return (
    <fieldset class="row">
      <legend class="visually-hidden">Methods in the link</legend>
      {methods.value.map((method) => (
        <label key={method} class="check">
          <input
            type="checkbox"
            checked={chosen.value.has(method)}
            onChange={(event) => {
              const others = [...chosen.value].filter((other) => other !== method);
              chosen.value = new Set(event.currentTarget.checked ? [...others, method] : others);
            }}
          />
          {method}
        </label>
      ))}
    </fieldset>
  );
}

function Contents({ results, length }: { results: SharedResults; length: number }): JSX.Element {
  const { claims, models, view, engine } = results;
  const again = models.filter(({ origin }) => origin.kind !== "files").length;
  const fits = claims.filter(({ fitted }) => fitted).length;
  const unhashed = claims.some(({ submission }) => submission === undefined);
  return (
    <>
      <p class="hint" data-testid="link-contents">
        {integer(length)} characters: {plural(claims.length, "result")} on {plural(models.length, "model")} with all
        digits, protocol {results.protocol}, engine {engine}
        {!unhashed && ", hashes of the files"}
        {view && `, ${view.camera ? "camera and " : ""}selection`}
        {again > 0 && `; ${again === models.length ? "the models are" : `${again} of the models are`} made or downloaded again for whoever opens it`}
        {fits > 0 && again > 0 && `, ${plural(fits, "fit")} repeated`}
        {again < models.length && "; no points of your files"}.
      </p>
      {unhashed && (
        <p class="hint">
          This page was not loaded over a safe connection, where browsers do not hash files. Nobody will be able to
          check these claims: open the page over https to share them.
        </p>
      )}
    </>
  );
}

async function make(rows: typeof scoredRows.value): Promise<Made> {
  try {
    if (rows.length === 0) return { kind: "failed", message: "Choose at least one method." };
    const results = await collect(rows, protocol.peek(), looking(), {
      page: thisPage,
      engine: await engineVersion(),
      fingerprintsOf: ({ entry, reports }) => fingerprintsOf(entry.source.files, reports.method),
    });
    return { kind: "made", fragment: writeFragment(results), results };
  } catch (error) {
    return { kind: "failed", message: error instanceof Error ? error.message : String(error) };
  }
}

/** The page's own address with the results and nothing else. */
function addressWith(fragment: string): string {
  return `${location.origin}${location.pathname}${fragment}`;
}

/** Everything in a link is a letter, a digit or a mark that needs no escape in an attribute. */
function embedding(link: string): string {
  const address = link.replace("#", "?embed#");
  return `<iframe src="${address}" title="Fit4CAD results" width="960" height="540" loading="lazy"></iframe>`;
}
