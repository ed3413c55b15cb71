// `?embed`: the results of a link, or the models of a zip, to look at: for slides and course pages.
// Nothing can be added or changed.

import type { JSX } from "preact";
import { taking } from "../intake/intake";
import { ExplainPopover } from "../measures/explain";
import { PictureDialog } from "../picture/dialog";
import { dataAsked } from "../public/address";
import { shortfall } from "../public/download";
import { DownloadProgress } from "../public/progress";
import ScoresPanel from "../scores/panel";
import SharedPanel from "../sharing/panel";
import { Standing, StopButton } from "../sharing/banner";
import { isLinkOpen, opened, rebuilding } from "../sharing/state";
import { Stage } from "../stage/stage";
import { models } from "../state/models";
import { plural } from "../ui/format";

export default function Embed(): JSX.Element {
  const shared = isLinkOpen();
  const hasScene = models.value.length > 0;
  return (
    <div class="embed">
      <header class="bar">
        <h1 class="brand">
          Fit4CAD <span>Playground</span>
        </h1>
        <p role="status">{shared ? <Standing embedded /> : hasScene && plural(models.value.length, "model")}</p>
        {rebuilding.value && <StopButton />}
        <a href={fullAddress()} target="_blank" rel="noopener">
          Open full
        </a>
      </header>
      <main class={hasScene ? "with-scene" : undefined}>
        {hasScene && <Stage />}
        {shared || hasScene ? (
          <div class="panel" tabIndex={0} role="region" aria-label="Figures">
            <Problem />
            <DownloadProgress id="download-embedded" />
            {shared ? <SharedPanel /> : <ScoresPanel />}
          </div>
        ) : (
          <div class="empty">
            <Problem />
            <DownloadProgress id="download-embedded" />
            <Nothing />
          </div>
        )}
      </main>
      <ExplainPopover />
      <PictureDialog />
    </div>
  );
}

/** What the address names and the page could not open. */
function Problem(): JSX.Element | null {
  const state = opened.value;
  const told = [...(state.kind === "damaged" ? [state.message] : []), ...(shortfall.value ? [shortfall.value.summary] : [])];
  return told.length > 0 ? <p role="alert">{told.join(" ")}</p> : null;
}

function Nothing(): JSX.Element | null {
  if (opened.value.kind === "damaged" || shortfall.value) return null;
  if (taking.value || dataAsked() !== undefined) return <p>Opening the data…</p>;
  return <p>This address holds no results. Embed one that was copied under “Share”, or name a zip with ?data=.</p>;
}

/** The same on the page itself. */
function fullAddress(): string {
  const query = new URLSearchParams(location.search);
  query.delete("embed");
  return `${location.pathname}${query.size > 0 ? `?${query}` : ""}${location.hash}`;
}
