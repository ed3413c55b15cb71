// Says that the page was opened with a link, and how its claims stand.

import type { JSX } from "preact";
import { goToPanel } from "../shell/panels";
import { plural } from "../ui/format";
import { Icon } from "../ui/icon";
import { closeLink, engineHere, isLinkOpen, judged, opened, SHARED_PANEL, tally } from "./opened";
import { failed, fitsOf, rebuild, rebuilding, recomputingOf, restOf, stopRebuilding, workOf, type Recomputing } from "./rebuild";
import type { SharedResults } from "./shared";

export function SharedBanner(): JSX.Element | null {
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
      The link was made with engine {state.results.engine}, this is {here}.
    </>
  );
}

/** How the claims stand, in a sentence. */
export function Standing({ embedded = false }: { embedded?: boolean }): JSX.Element {
  const all = judged.value.length;
  const { verified, differs, uncheckable, "other files": others } = tally.value;
  if (all === 0) return <>This link holds no results.</>;
  if (uncheckable === all) {
    return (
      <>
        <strong>As claimed.</strong> {plural(all, "shared result")}. The link does not say which files they are about, so
        they cannot be checked.
      </>
    );
  }
  if (differs > 0) {
    return (
      <>
        <strong>{differs === all ? "The figures differ." : `${differs} of ${plural(all, "result")} differ.`}</strong> The
        same files, scored here, gave other figures.
        <OtherEngine />
      </>
    );
  }
  if (verified === all) {
    return (
      <>
        <strong>Verified here.</strong> {plural(all, "shared result")}: the same files, scored on this computer, gave
        every digit.
      </>
    );
  }
  const open = judged.value.filter(({ verdict }) => verdict.kind === "claimed").map(recomputingOf);
  const count = (wanted: Recomputing) => open.filter((how) => how === wanted).length;
  const [underWay, unfitted, notDone] = [count("under way"), count("failed"), count("not done")];
  const toDrop = all - verified - underWay - unfitted - notDone;
  return (
    <>
      <strong>As claimed.</strong> {plural(all, "shared result")}
      {verified > 0 && `, ${verified} verified here`}
      {others > 0 && `, ${others} with other files`}
      {underWay > 0 && `, ${underWay} being recomputed`}
      {unfitted > 0 && `, ${unfitted} whose fit failed`}
      {notDone > 0 && `, ${notDone} not recomputed`}.
      {toDrop > 0 && ` ${embedded ? "Open full" : "Drop the same files on the page"} to check ${toDrop < all ? "the rest" : "them"}.`}
      <Failed />
    </>
  );
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
