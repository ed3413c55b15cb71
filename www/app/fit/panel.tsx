// Fit primitives to the clouds on the page, with either method of the paper.

import type { JSX } from "preact";
import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { cancelFitting, fitModels, fitProgress } from "../state/fitting";
import { modelById, models, type ModelEntry } from "../state/models";
import { selectedModel } from "../state/selection";
import * as format from "../ui/format";
import { Parameter } from "./parameter";
import { Results } from "./results";
import {
  DEFAULT_SEED,
  METHODS,
  anyChanged,
  loadParameters,
  method,
  parameters,
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
  const failure = useSignal<string | undefined>(undefined);
  useEffect(() => {
    loadParameters().catch((error: unknown) => {
      failure.value = error instanceof Error ? error.message : String(error);
    });
  }, [failure]);
  return (
    <div class="fit">
      <form
        onSubmit={(event) => {
          event.preventDefault();
          const all = event.submitter?.getAttribute("value") === "all";
          const chosen = all ? models.value : models.value.filter(({ id }) => id === selectedModel.value);
          const how = request.value;
          void fitModels(chosen.filter(hasCloud).map(({ id }) => ({ model: id, request: how })));
        }}
      >
        <Choice />
        <Run />
        {failure.value !== undefined && (
          <p class="empty" role="alert">
            The parameters could not be loaded: {failure.value}
          </p>
        )}
        <div class="parameters" key={method.value}>
          {parameters.value?.map((info) => (
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

function Choice(): JSX.Element {
  const chosen = METHODS.find(({ id }) => id === method.value);
  return (
    <div class="fit-method">
      <fieldset class="switch">
        <legend class="visually-hidden">Method to fit with</legend>
        {METHODS.map(({ id, title }) => (
          <label key={id}>
            <input type="radio" name="fit-method" checked={id === method.value} onChange={() => (method.value = id)} />
            <span>{title}</span>
          </label>
        ))}
      </fieldset>
      <p>{chosen?.about}</p>
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
