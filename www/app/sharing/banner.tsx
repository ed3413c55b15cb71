// Says that the page was opened with a link, and how its claims stand.

import type { JSX } from "preact";
import { goToPanel } from "../shell/panels";
import { plural } from "../ui/format";
import { Icon } from "../ui/icon";
import { closeLink, engineHere, isLinkOpen, judged, opened, SHARED_PANEL, tally } from "./opened";
import { entryOf, isRebuildable, rebuild, rebuilding, workOf } from "./rebuild";
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

/** Has the rest of the models again that the link says how to, and repeats the fits it names. */
function RestButton({ results }: { results: SharedResults }): JSX.Element | null {
  const places = results.models.flatMap((model, place) => {
    const absent = entryOf(model) === undefined;
    const unfitted = judged.value.some(({ claim, verdict }) => claim.model === place && claim.fitted && verdict.kind === "claimed");
    return absent ? (isRebuildable(model) ? [place] : []) : unfitted ? [place] : [];
  });
  if (places.length === 0 || rebuilding.value) return null;
  const { samples, downloads, fits } = workOf(results, places);
  const parts = [
    samples > 0 && `make ${plural(samples, "sample")}`,
    downloads > 0 && `download ${plural(downloads, "public model")}`,
    fits > 0 && `repeat ${plural(fits, "fit")}`,
  ].filter((part) => part !== false);
  const text = parts.join(", ");
  return (
    <button type="button" onClick={() => void rebuild(results, places)}>
      {text.charAt(0).toUpperCase() + text.slice(1)}
    </button>
  );
}

function Close(): JSX.Element {
  return (
    <button type="button" class="icon" aria-label="Close the link" onClick={closeLink}>
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
  return (
    <>
      <strong>As claimed.</strong> {plural(all, "shared result")}
      {verified > 0 && `, ${verified} verified here`}
      {others > 0 && `, ${others} with other files`}. {embedded ? "Open full" : "Drop the same files on the page"} to
      check {verified > 0 ? "the rest" : "them"}.
    </>
  );
}
