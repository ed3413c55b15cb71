// `?embed`: the results of a link to look at, for slides and course pages. Nothing can be added or changed.

import type { JSX } from "preact";
import { ExplainPopover } from "../measures/explain";
import SharedPanel from "../sharing/panel";
import { Standing } from "../sharing/banner";
import { isLinkOpen, opened } from "../sharing/opened";
import { Stage } from "../stage/stage";
import { models } from "../state/models";

export default function Embed(): JSX.Element {
  const shared = isLinkOpen();
  const hasScene = models.value.length > 0;
  return (
    <div class="embed">
      <header class="bar">
        <h1 class="brand">
          Fit4CAD <span>Playground</span>
        </h1>
        <p role="status">{shared && <Standing embedded />}</p>
        <a href={fullAddress()} target="_blank" rel="noopener">
          Open full
        </a>
      </header>
      <main class={hasScene ? "with-scene" : undefined}>
        {hasScene && <Stage />}
        {shared ? (
          <div class="panel" tabIndex={0} role="region" aria-label="Figures">
            <SharedPanel />
          </div>
        ) : (
          <NoResults />
        )}
      </main>
      <ExplainPopover />
    </div>
  );
}

function NoResults(): JSX.Element {
  const state = opened.value;
  if (state.kind === "damaged") {
    return (
      <p class="empty" role="alert">
        {state.message}
      </p>
    );
  }
  return <p class="empty">This address holds no results. Embed one that was copied under “Share”.</p>;
}

/** The same results on the page itself. */
function fullAddress(): string {
  return `${location.pathname}${location.hash}`;
}
