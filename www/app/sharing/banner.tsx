// Says that the page was opened with a link, and how its claims stand.

import type { JSX } from "preact";
import { goToPanel } from "../state/panels";
import { plural } from "../ui/format";
import { Icon } from "../ui/icon";
import { wordsOf } from "./basis";
import { judged, tally } from "./opened";
import { workOf } from "./plan";
import { failed, fitsOf, rebuild, recomputingOf, restOf, type Recomputing } from "./rebuild";
import type { SharedResults } from "./shared";
import { closeLink, engineHere, isLinkOpen, opened, rebuilding, SHARED_PANEL, stopRebuilding } from "./state";
import { versionWords } from "./version";

export default function Banner(): JSX.Element | null {
  const state = opened.value;
  if (state.kind === "none") return null;
  if (state.kind === "damaged") {
    return (
      <section class="banner" data-kind="error" aria-label="Shared link">
        <p role="alert">
          <Icon name="error" />
          {state.message}
        </p>
        <Close />
      </section>
    );
  }
  return (
    <section class="banner" data-kind={kindOf()} aria-label="Shared link">
      <p role="status">
        <Standing />
      </p>
      <RestButton results={state.results} />
      <button type="button" onClick={() => goToPanel(SHARED_PANEL)}>
        Show the figures
      </button>
      <Close />
    </section>
  );
}

/** Has again what the link says how to, or ends that. */
function RestButton({ results }: { results: SharedResults }): JSX.Element | null {
  if (rebuilding.value) return <StopButton />;
  const rest = restOf(results);
  const work = workOf(results, rest);
  return work === undefined ? null : (
    <button type="button" onClick={() => void rebuild(results, rest)}>
      {work}
    </button>
  );
}

export function StopButton(): JSX.Element {
  return (
    <button type="button" onClick={stopRebuilding}>
      Stop recomputing
    </button>
  );
}

function Close(): JSX.Element {
  return (
    <button
      type="button"
      class="icon"
      aria-label="Close the link"
      onClick={() => {
        stopRebuilding();
        closeLink();
      }}
    >
      <Icon name="close" />
    </button>
  );
}

function kindOf(): "good" | "error" | "note" {
  const { differs, verified } = tally.value;
  if (differs > 0) return "error";
  return isLinkOpen() && verified > 0 && verified === judged.value.length ? "good" : "note";
}

/** Another version of the engine may well give other figures, and nobody has cheated. */
function OtherEngine(): JSX.Element | null {
  const [here, state] = [engineHere.value, opened.value];
  if (state.kind !== "shared" || here === undefined || here === state.results.engine) return null;
  return (
    <>
      {" "}
      Claimed with {versionWords(state.results.engine)}, checked with engine {here}.
    </>
  );
}

/** By which rules, where they are not those of the paper's definitions. */
function rules(): string {
  const state = opened.value;
  return state.kind === "shared" && state.results.protocol === "published" ? " under the published protocol" : "";
}

/** How the claims stand, in a sentence or two. */
export function Standing({ embedded = false }: { embedded?: boolean }): JSX.Element {
  return (
    <>
      <Verdicts embedded={embedded} />
      <OtherEngine />
    </>
  );
}

function Verdicts({ embedded }: { embedded: boolean }): JSX.Element {
  const all = judged.value.length;
  const { verified, recomputed, renamed, copied, repeated, differs, uncheckable, "other files": others } = tally.value;
  const results = `${plural(all, "shared result")}${rules()}`;
  if (all === 0) return <>This link holds no results.</>;
  if (uncheckable === all) {
    return (
      <>
        <strong>As claimed.</strong> {results}. It cannot be told which files they are about, so they cannot be checked.
      </>
    );
  }
  if (differs > 0) {
    return (
      <>
        <strong>{differs === all ? "The figures differ." : `${differs} of ${plural(all, "result")} differ.`}</strong> The
        same files, scored here, gave other figures.
      </>
    );
  }
  if (verified === all) {
    return (
      <>
        <strong>Verified here.</strong> {results}: the same files, scored on this computer, gave every digit.
      </>
    );
  }
  const weak = [renamed > 0 && `${renamed} of files that are called otherwise here`, copied > 0 && `${copied} of the ground truth itself`];
  const repeats = repeated > 0 && (all === repeated + 1 ? "all of them one and the same" : `${repeated} repeating others of them`);
  if (recomputed > 0 && recomputed + repeated === all) {
    return (
      <>
        <strong>Recomputed from the link.</strong> {results}
        {repeats && `, ${repeats}`}: {scored()}, made again on this computer, gave every digit. What the link calls{" "}
        {all === 1 ? "it" : "them"} is not borne out.
      </>
    );
  }
  const open = judged.value.filter(({ verdict }) => verdict.kind === "claimed").map(recomputingOf);
  const count = (wanted: Recomputing) => open.filter((how) => how === wanted).length;
  const [underWay, unfitted, notDone, toDrop] = [count("under way"), count("failed"), count("not done"), count("not possible") + others];
  const parts = [
    verified > 0 && `${verified} verified here`,
    recomputed > 0 && `${recomputed} recomputed from the link`,
    ...weak,
    repeats,
    others > 0 && `${others} with other files`,
    underWay > 0 && `${underWay} being recomputed`,
    unfitted > 0 && `${unfitted} whose fit failed`,
    notDone > 0 && `${notDone} not recomputed`,
    uncheckable > 0 && `${uncheckable} that cannot be checked`,
  ];
  return (
    <>
      <strong>As claimed.</strong> {[results, ...parts.filter((part) => part !== false)].join(", ")}.
      {toDrop > 0 && ` ${embedded ? "Open full" : "Drop the same files on the page"} to check ${toDrop < all ? "the rest" : "them"}.`}
      <Failed />
    </>
  );
}

/** Most things told one by one. */
const FEW = 2;

/** What was scored here, each once: `PG (seed 1) on the sample bracket, and 3 others`. */
function scored(): string {
  const bases = [...new Set(judged.value.flatMap(({ verdict }) => ("basis" in verdict ? [wordsOf(verdict.basis)] : [])))];
  const more = bases.length - FEW;
  return `${bases.slice(0, FEW).join("; ")}${more > 0 ? `, and ${plural(more, "other")}` : ""}`;
}

/** The first reason why a fit failed; the panel tells them all. */
function Failed(): JSX.Element | null {
  const [first, ...others] = failed.value;
  if (!first) return null;
  return (
    <>
      {" "}
      {fitsOf(first)}: {first.reason}
      {others.length > 0 && ` (${plural(others.length, "other reason")}: see the figures)`}
    </>
  );
}
