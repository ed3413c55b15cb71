// How a STEP file is imported: every option that Rust declares, and the choice of bodies.

import type { JSX } from "preact";
import { signal, useSignal, type Signal } from "@preact/signals";
import { useId, useMemo } from "preact/hooks";
import type { BodyReport, ImportOptions, OptionInfo } from "../../generated/cad/cad.js";
import { IMPORT_OPTIONS } from "../../generated/declared/import-options.js";
import { sentence } from "../../shared/text.mjs";
import { importing } from "../intake/step";
import { madeSubmissions } from "../state/made";
import type { StepSource } from "../state/origin";
import * as format from "../ui/format";
import { importAgain } from "./reimport";

/** Values by the names of their options; what is not there is as declared. */
type Values = Readonly<Record<string, number | string | boolean>>;

/** The one of these that is given tells how many points there are. */
const AMOUNTS: readonly string[] = ["points", "spacing"];

export function ImportForm({ id, step }: { id: string; step: StepSource }): JSX.Element {
  // What is entered while an import runs stays: it begins with how the model was made, and anew with another file alone.
  const values = useMemo(() => signal<Values>({ ...step.options } as Values), [step.data]);
  const bodies = useMemo(() => signal<readonly number[]>(step.report.choice.flatMap(({ kept }, at) => (kept ? [at + 1] : []))), [step.data]);
  const stop = useSignal<AbortController | undefined>(undefined);
  const failure = useSignal("");
  const fits = madeSubmissions.value.get(id)?.size ?? 0;
  const running = stop.value !== undefined;
  const all = bodies.value.length === step.report.choice.length;

  // Where neither is given, what came of it stands in their places.
  const points = step.report.faces.reduce((sum, face) => sum + face.points, 0);
  const given = AMOUNTS.some((name) => values.value[name] !== undefined);
  const now: Readonly<Record<string, string>> = given ? {} : { points: String(points), spacing: step.report.spacing.toPrecision(3) };

  const run = async () => {
    const own = new AbortController();
    stop.value = own;
    failure.value = "";
    try {
      const how = { options: { ...values.value } as ImportOptions, ...(!all && { bodies: bodies.value }) };
      await importAgain(id, step, how, own);
    } catch (error) {
      if (!own.signal.aborted) failure.value = sentence(error instanceof Error ? error.message : String(error));
    } finally {
      stop.value = undefined;
    }
  };

  return (
    <form
      class="cad-form"
      aria-label={`How ${step.path} is imported`}
      onSubmit={(event) => {
        event.preventDefault();
        void run();
      }}
    >
      <div class="cad-run">
        <button type="submit" class="primary" disabled={running || bodies.value.length === 0}>
          Import again
        </button>
        {running && (
          <>
            <button type="button" onClick={() => stop.value?.abort()}>
              Cancel
            </button>
            <progress aria-label="Import" max={1} value={importing.value?.share ?? 0} />
          </>
        )}
        <p role="status">
          {running && format.capitalised(importing.value?.stage ?? "waiting")}
          {!running && bodies.value.length === 0 && "Keep at least one body."}
          {!running && bodies.value.length > 0 && fits > 0 && `${format.plural(fits, "fit")} of ${id} will be removed: the points will be others.`}
        </p>
        {failure.value && (
          <p class="cad-failure" role="alert">
            {failure.value}
          </p>
        )}
      </div>
      <div class="parameters">
        {IMPORT_OPTIONS.map((info) => (
          <Option key={info.name} info={info} values={values} now={now[info.name]} />
        ))}
      </div>
      {step.report.choice.length > 1 && <Bodies choice={step.report.choice} kept={bodies} />}
    </form>
  );
}

interface OptionProps {
  readonly info: OptionInfo;
  readonly values: Signal<Values>;
  /** What holds now without it being given. */
  readonly now: string | undefined;
}

function Option({ info, values, now }: OptionProps): JSX.Element {
  const id = useId();
  const { name, value, unit, explanation } = info;
  const given = values.value[name];
  const set = (to: Values[string] | undefined) => {
    const gone = to !== undefined && AMOUNTS.includes(name) ? AMOUNTS : [name];
    const others = Object.fromEntries(Object.entries(values.value).filter(([other]) => !gone.includes(other)));
    values.value = to === undefined ? others : { ...others, [name]: to };
  };
  return (
    <div class="parameter" data-changed={given !== undefined || undefined}>
      <label for={id}>{format.capitalised(name)}</label>
      <span class="value">
        <Field id={id} info={info} given={given} now={now} set={set} />
        {unit && <span class="unit">{unit}</span>}
      </span>
      <p id={`${id}-about`}>
        {explanation}
        {value.kind === "number" && value.whole && (
          <span class="range">
            {" "}
            {format.integer(value.minimum)} to {format.integer(value.maximum)}.
          </span>
        )}
      </p>
    </div>
  );
}

interface FieldProps {
  readonly id: string;
  readonly info: OptionInfo;
  readonly given: Values[string] | undefined;
  readonly now: string | undefined;
  readonly set: (to: Values[string] | undefined) => void;
}

function Field({ id, info, given, now, set }: FieldProps): JSX.Element {
  const { value } = info;
  const about = `${id}-about`;
  if (value.kind === "flag") {
    return <input id={id} type="checkbox" aria-describedby={about} checked={given === true} onChange={(event) => set(event.currentTarget.checked || undefined)} />;
  }
  if (value.kind === "choice") {
    const [usual = ""] = value.words;
    return (
      <select id={id} aria-describedby={about} value={String(given ?? usual)} onChange={({ currentTarget }) => set(currentTarget.value === usual ? undefined : currentTarget.value)}>
        {value.words.map((word) => (
          <option key={word}>{word}</option>
        ))}
      </select>
    );
  }
  return (
    <input
      id={id}
      type="number"
      inputMode={value.whole ? "numeric" : "decimal"}
      min={value.minimum}
      max={value.maximum}
      step={value.whole ? 1 : "any"}
      placeholder={info.default === null ? now : String(info.default)}
      value={given === undefined ? "" : String(given)}
      aria-describedby={about}
      onInput={({ currentTarget }) => {
        // What is half typed is for the browser to judge, when it is sent.
        const entered = currentTarget.valueAsNumber;
        set(Number.isFinite(entered) ? entered : undefined);
      }}
    />
  );
}

/** More would not be read through; the command line takes any by their numbers. */
const MOST_BODIES = 200;

function Bodies({ choice, kept }: { choice: readonly BodyReport[]; kept: Signal<readonly number[]> }): JSX.Element {
  const turn = (number: number, on: boolean) => {
    const others = kept.value.filter((each) => each !== number);
    kept.value = on ? [...others, number].sort((a, b) => a - b) : others;
  };
  const all = choice.map((_, at) => at + 1);
  return (
    <fieldset class="cad-bodies">
      <legend>Bodies</legend>
      <p>
        <button type="button" class="link" onClick={() => (kept.value = all)}>
          All
        </button>
        <button type="button" class="link" onClick={() => (kept.value = [])}>
          None
        </button>
      </p>
      <ul>
        {choice.slice(0, MOST_BODIES).map(({ name, faces }, at) => (
          <li key={String(at)}>
            <label>
              <input type="checkbox" checked={kept.value.includes(at + 1)} onChange={(event) => turn(at + 1, event.currentTarget.checked)} />
              {at + 1} {name}, {format.plural(faces, "face")}
            </label>
          </li>
        ))}
      </ul>
      {choice.length > MOST_BODIES && <p>The first {MOST_BODIES} of {format.integer(choice.length)}.</p>}
    </fieldset>
  );
}
