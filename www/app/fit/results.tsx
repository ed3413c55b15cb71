// The models of a run: how far each is, and what came of it.

import type { JSX } from "preact";
import { fitRun, methodsOf, shareDone, type Fit, type FitRun, type FitState } from "../state/fitting";
import { removeMade } from "../state/contents";
import { isMadeHere } from "../state/made";
import { modelById } from "../state/models";
import { selectModel, selectedMethod, selectedModel } from "../state/selection";
import { protocol } from "../state/settings";
import * as format from "../ui/format";
import type { NoiseInfo } from "../engine/contract";
import { Answer } from "./answer";
import { isWindowed, Seen, type Place } from "../ui/seen";

export function Results(): JSX.Element | null {
  const run = fitRun.value;
  if (!run) return null;
  return (
    <div class="fits-box">
      <table class="fits" aria-rowcount={isWindowed(run.fits.length) ? run.fits.length + 1 : undefined}>
        <caption>
          {captionOf(run)}
        </caption>
        <thead>
          <tr>
            <th scope="col">Model</th>
            <th scope="col">Result</th>
            <th scope="col" class="numeric">
              Primitives
            </th>
            <th scope="col" class="numeric">
              Seconds
            </th>
            <th scope="col" class="numeric">
              Noise
            </th>
            <th scope="col" class="numeric">
              DSC
            </th>
            <th scope="col">
              <span class="visually-hidden">Actions</span>
            </th>
          </tr>
        </thead>
        <Seen
          as="tbody"
          items={run.fits}
          columns={7}
          handle=".row-name"
          draw={(fit, place) => <Row key={`${place["data-place"]} ${fit.model}`} fit={fit} place={place} />}
        />
      </table>
      <Answer run={run} />
    </div>
  );
}

/** A run that repeats what a link claims may fit a model several times. */
function captionOf(run: FitRun): string {
  const { fits } = run;
  const count = new Set(fits.map(({ model }) => model)).size;
  const times = fits.length > count ? `${format.plural(fits.length, "fit")}, ` : "";
  return `${times}${methodsOf(run)} on ${format.plural(count, "model")}`;
}

function Row({ fit, place }: { fit: Fit; place: Place }): JSX.Element {
  const state = fit.state.value;
  const result = state.kind === "done" ? state.result : undefined;
  const there = result !== undefined && isMadeHere(fit.model, result.method);
  const shown = there && selectedModel.value === fit.model && selectedMethod.value === result.method;
  return (
    <tr {...place} aria-current={shown ? "true" : undefined}>
      <th scope="row">
        {there ? (
          <button type="button" class="row-name" onClick={() => selectModel(fit.model, result.method)}>
            {fit.model}
          </button>
        ) : (
          fit.model
        )}
      </th>
      <td>
        <Outcome model={fit.model} state={state} removed={result !== undefined && !there} />
      </td>
      <td class="numeric">{result && format.integer(result.primitives)}</td>
      <td class="numeric">{result?.seconds.toFixed(2)}</td>
      <td class="numeric" title={result?.noise?.kind ?? undefined}>
        {result?.noise && noiseIn(result.noise)}
      </td>
      <td class="numeric">{there && dsc(fit.model, result.method)}</td>
      <td>
        {(state.kind === "queued" || state.kind === "running") && (
          <button type="button" class="link" aria-label={`Stop fitting ${fit.model}`} onClick={fit.stop}>
            Stop
          </button>
        )}
        {there && (
          <button
            type="button"
            class="link"
            aria-label={`Remove ${result.method} of ${fit.model}`}
            onClick={() => removeMade(fit.model, result.method)}
          >
            Remove
          </button>
        )}
      </td>
    </tr>
  );
}

/** In the units of the cloud; `none` of exact points. */
function noiseIn({ deviation, source }: NoiseInfo): string {
  return deviation > 0 ? `${format.length(deviation)} ${source}` : "none";
}

function Outcome({ model, state, removed }: { model: string; state: FitState; removed: boolean }): JSX.Element {
  switch (state.kind) {
    case "queued":
      return <>waiting</>;
    case "running":
      return (
        <span class="running">
          <progress max={1} value={shareDone(state)} aria-label={`Fitting ${model}`} />
          {state.stage}
        </span>
      );
    case "done":
      return <>{removed ? "removed" : state.result.method}</>;
    case "stopped":
      return <>stopped</>;
    case "failed":
      return (
        <span class="mark error" role="alert">
          {state.message}
        </span>
      );
  }
}

function dsc(model: string, method: string): string {
  const status = modelById(model)?.status;
  if (status?.kind === "waiting") return "…";
  if (status?.kind !== "scored") return "";
  if (!status.result.info.hasTruth) return "no truth";
  const reports = status.result.reports.find((each) => each.method === method);
  return format.measure("DSC", reports?.[protocol.value].mean.DSC);
}
