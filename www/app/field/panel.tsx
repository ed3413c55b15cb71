// The submissions by every protocol of the field, side by side: what each rewards, and who wins by it.

import type { JSX } from "preact";
import { useEffect } from "preact/hooks";
import { NORMALISATIONS } from "../../generated/declared/normalisations.js";
import { STRATA } from "../../generated/declared/strata.js";
import type { FieldSums } from "../../worker/protocol";
import type { FigureInfo } from "../engine/contract";
import { PageLink } from "../navigation/page-link";
import { remembered } from "../state/settings";
import { Choice } from "../ui/choice";
import { plural } from "../ui/format";
import { Lazy } from "../ui/lazy";
import { FIGURES_OF_FIT, PROTOCOLS_OF_FIELD } from "./figures";
import { MeansTable } from "./means";
import { PairsTable } from "./pairs";
import { SaveButtons } from "./save";
import { answers, by, current, EPSILONS, epsilon, follow, normalisation, particulars, sums } from "./state";
import "./field.css";

const VIEWS = [
  ["protocols", "Protocols"],
  ["fit", "Figures of fit"],
  ["strata", "Strata"],
  ["segments", "Segments"],
] as const;

const loadStrata = () => import("./strata");
const loadSegments = () => import("./segments");

const view = remembered<(typeof VIEWS)[number][0]>("field", "protocols", VIEWS.map(([id]) => id));

export default function FieldPanel(): JSX.Element {
  useEffect(follow, []);
  const { reports, failed } = answers.value;
  const isByStrata = view.value === "strata" || view.value === "segments";
  const progress = current.value.progress.value ?? (isByStrata ? particulars.value.progress.value : undefined);
  const found = sums.value;
  return (
    <div class="field-panel">
      <div class="panel-tools">
        <Choice label="Show" value={view.value} options={VIEWS} onChange={(to) => (view.value = to)} />
        {isByStrata && <Strata />}
        {view.value !== "protocols" && <Scale hasEpsilon={view.value !== "segments"} />}
        {found && <SaveButtons />}
        {progress && <progress aria-label="Models compared" value={progress.done} max={progress.total} />}
      </div>
      {found ? <Shown found={found} /> : <p class="empty">{progress || reports.length > 0 ? "Comparing…" : "Nothing is scored yet that could be compared."}</p>}
      {failed.length > 0 && (
        <p role="alert">
          {plural(failed.length, "model")} could not be compared: {failed.map(({ id, reason }) => `${id}: ${reason}`).join("; ")}
        </p>
      )}
    </div>
  );
}

function Shown({ found: { spreads, comparisons } }: { found: FieldSums }): JSX.Element {
  const scale = { normalisation: normalisation.value, epsilon: Number(epsilon.value) };
  switch (view.value) {
    case "protocols":
      return (
        <>
          <p class="note">
            Below each mean its bootstrap 95 % interval, the median and the quartiles. Places are marked ▲ ▼ where they are not
            those by the first protocol.
          </p>
          <MeansTable
            caption="Means over models, by protocol"
            figures={PROTOCOLS_OF_FIELD}
            spreads={spreads}
            scale={scale}
            ranked
          />
          <Explained figures={PROTOCOLS_OF_FIELD} title="What each protocol rewards" />
          <p class="note">
            Two of these protocols give full marks for one face. <PageLink id="lesson-protocols">How to win by protocol</PageLink> shows
            how, on a live part.
          </p>
          <PairsTable figures={PROTOCOLS_OF_FIELD} comparisons={comparisons} />
        </>
      );
    case "fit":
      return (
        <>
          <p class="note">
            True and predicted primitives are matched one to one by IoU. {meaningOf(scale.normalisation)} Samples are the points of
            the true primitive, each on its true surface: all of them, so no figure hangs on a seed.
          </p>
          <MeansTable
            caption="Means over models"
            figures={FIGURES_OF_FIT}
            spreads={spreads}
            scale={scale}
            ranked={false}
          />
          <Explained figures={FIGURES_OF_FIT} title="What the figures say" />
          <PairsTable figures={FIGURES_OF_FIT} comparisons={comparisons} />
        </>
      );
    case "strata":
      return <Lazy load={loadStrata} title="Strata" />;
    case "segments":
      return <Lazy load={loadSegments} title="Segments" />;
  }
}

function meaningOf(name: string): string {
  return NORMALISATIONS.find((each) => each.name === name)?.meaning ?? "";
}

function Strata(): JSX.Element {
  return (
    <label>
      By{" "}
      <select value={by.value} onChange={(event) => (by.value = STRATA.find(({ name }) => name === event.currentTarget.value)?.name ?? by.peek())}>
        {STRATA.map(({ name, title }) => (
          <option key={name} value={name}>
            {title}
          </option>
        ))}
      </select>
    </label>
  );
}

function Scale({ hasEpsilon }: { hasEpsilon: boolean }): JSX.Element {
  return (
    <>
      <label>
        Lengths over{" "}
        <select value={normalisation.value} onChange={(event) => (normalisation.value = event.currentTarget.value)}>
          {NORMALISATIONS.map(({ name }) => (
            <option key={name} value={name}>
              {name}
            </option>
          ))}
        </select>
      </label>
      {hasEpsilon && (
        <label>
          ε{" "}
          <select value={epsilon.value} onChange={(event) => (epsilon.value = event.currentTarget.value)}>
            {EPSILONS.map((each) => (
              <option key={each} value={each}>
                {each}
              </option>
            ))}
          </select>
        </label>
      )}
    </>
  );
}

/** One sentence a figure; the rest on demand. */
function Explained({ figures, title }: { figures: readonly FigureInfo[]; title: string }): JSX.Element {
  return (
    <section class="rewards" aria-label={title}>
      <h3>{title}</h3>
      {figures.map(({ key, title: name, rewards, definition, trap, labels, source }) => (
        <details key={key}>
          <summary>
            <b>{name}.</b> {rewards}
          </summary>
          <dl>
            <dt>Definition</dt>
            <dd>{definition}</dd>
            <dt>Trap</dt>
            <dd>{trap}</dd>
            <dt>Labels</dt>
            <dd>{labels}</dd>
            <dt>Source</dt>
            <dd>{source}</dd>
          </dl>
        </details>
      ))}
    </section>
  );
}
