// Fit primitives to the clouds on the page, with either method of the paper.

import type { JSX } from "preact";
import { FITTERS } from "../../generated/declared/fitters.js";
import type { FitRequest } from "../../worker/protocol";
import { cancelFitting, fitModels, fitProgress } from "../state/fitting";
import { modelById, models, type ModelEntry } from "../state/models";
import { selectedModel } from "../state/selection";
import * as format from "../ui/format";
import { capitalised } from "../ui/format";
import { Outlook, smaller } from "./outlook";
import { Parameter } from "./parameter";
import { Results } from "./results";
import {
  DEFAULT_SEED,
  anyChanged,
  fitter,
  method,
  request,
  resetAll,
  seed,
  setParameter,
  valueOf,
} from "./settings";

const SEED = {
  name: "seed",
  unit: "",
  minimum: 0,
  maximum: 2 ** 32 - 1,
  default: DEFAULT_SEED,
  whole: true,
  explanation: "Of everything random. The same cloud, parameters and seed give the same primitives.",
} as const;

function hasCloud({ source }: ModelEntry): boolean {
  return source.files.some(({ role }) => role === "cloud");
}

export default function FitPanel(): JSX.Element {
  return (
    <div class="fit">
      <form
        onSubmit={(event) => {
          event.preventDefault();
          const all = event.submitter?.getAttribute("value") === "all";
          const chosen = all ? models.value : models.value.filter(({ id }) => id === selectedModel.value);
          const how = event.submitter?.getAttribute("value") === "some" ? withSubsample(smaller.value?.points) : request.value;
          void fitModels(chosen.filter(hasCloud).map(({ id }) => ({ model: id, request: how })));
        }}
      >
        <Choice />
        <Run />
        <Outlook />
        <div class="parameters" key={method.value}>
          {fitter.value?.parameters.map((info) => (
            <Parameter key={info.name} info={info} value={valueOf(info.name)} onChange={(value) => setParameter(info.name, value)} />
          ))}
          <Parameter
            info={SEED}
            value={seed.value === DEFAULT_SEED ? undefined : seed.value}
            onChange={(value) => (seed.value = value ?? DEFAULT_SEED)}
          />
        </div>
      </form>
      <Results />
    </div>
  );
}

/** What is asked for, of so many points. */
function withSubsample(points: number | undefined): FitRequest {
  const { parameters, ...how } = request.value;
  return { ...how, parameters: points === undefined ? parameters : { ...parameters, subsample: points } };
}

function Choice(): JSX.Element {
  return (
    <div class="fit-method">
      <fieldset class="switch">
        <legend class="visually-hidden">Method to fit with</legend>
        {FITTERS.map(({ name, title }) => (
          <label key={name}>
            <input type="radio" name="fit-method" checked={name === method.value} onChange={() => (method.value = name)} />
            <span>{title}</span>
          </label>
        ))}
      </fieldset>
      <p>
        {fitter.value && `${capitalised(fitter.value.fullName)}. ${fitter.value.meaning}`}
      </p>
    </div>
  );
}

function Run(): JSX.Element {
  const running = fitProgress.value !== undefined;
  const entry = modelById(selectedModel.value);
  const withCloud = models.value.filter(hasCloud).length;
  return (
    <div class="fit-run">
      <button type="submit" class="primary" disabled={running || !entry || !hasCloud(entry)}>
        Fit {entry?.id ?? "a model"}
      </button>
      {smaller.value && (
        <button type="submit" value="some">
          Fit {format.integer(smaller.value.points)} of its points
        </button>
      )}
      {withCloud > 1 && (
        <button type="submit" value="all" disabled={running}>
          Fit all {format.plural(withCloud, "model")}
        </button>
      )}
      {running && (
        <button type="button" onClick={cancelFitting}>
          Cancel
        </button>
      )}
      <button type="button" class="link" disabled={!anyChanged.value} onClick={resetAll}>
        Reset all
      </button>
    </div>
  );
}
