// What came of a fit, in words: how noisy the points are, what was found and how surely, what was left out, what to try next.

import type { JSX } from "preact";
import { useEffect } from "preact/hooks";
import type { NoiseInfo, PrimitiveInfo } from "../engine/contract";
import { errorsOf, follow, isLoose } from "../primitives/sure";
import { colourMode } from "../stage/display";
import { setHidden } from "../stage/isolation";
import { type FitRun } from "../state/fitting";
import { modelById } from "../state/models";
import { goToPanel } from "../state/panels";
import { scene } from "../state/scene";
import { selectedMethod, selectedModel, selectedPrimitive } from "../state/selection";
import type { ModelScene, SegmentationScene } from "../../worker/protocol";
import * as format from "../ui/format";

/** Fewer points than this share of the cloud make a primitive that may be nothing but noise. */
const SMALL = 0.005;
/** From this share on it is worth looking at what is in no primitive. */
const MUCH = 0.02;

/** Of the submission in view, where the run made it. */
export function Answer({ run }: { run: FitRun }): JSX.Element | null {
  useEffect(follow, []);
  const state = scene.value;
  const [model, method] = [selectedModel.value, selectedMethod.value];
  const made = run.fits.flatMap((fit) => {
    const fitted = fit.state.value;
    return fit.model === model && fitted.kind === "done" && fitted.result.method === method ? [fitted.result] : [];
  });
  const result = made.at(-1);
  if (!result || method === undefined || state.kind !== "ready" || state.scene.method !== method || !state.scene.prediction) return null;
  const { primitives } = state.scene.prediction;
  const points = state.scene.positions.length / 3;
  const left = leftOut(state.scene.prediction, points);
  return (
    <section class="answer" aria-label={`What ${method} found in ${model}`}>
      <h3>
        {format.plural(primitives.length, "primitive")} in {model}
      </h3>
      <dl>
        {result.noise && (
          <>
            <dt>Noise</dt>
            <dd>{noiseWords(result.noise, diagonalOf(model))}</dd>
          </>
        )}
        <dt>Certainty</dt>
        <dd>
          <Certainty shown={state.scene} primitives={primitives} />
        </dd>
        <dt>Left out</dt>
        <dd>
          {left === 0 ? (
            "No point: each is in a primitive."
          ) : (
            <>
              {format.plural(left, "point")} ({format.share(left / points)}): on no surface that was found, or in patches too small to
              be told from chance.{" "}
              <button type="button" class="link" title="All others are hidden until Escape" onClick={() => showLeftOut(primitives)}>
                Show only these
              </button>
            </>
          )}
        </dd>
        <dt>Next</dt>
        <dd>
          <Next primitives={primitives} noise={result.noise} left={left / points} points={points} />
        </dd>
      </dl>
    </section>
  );
}

function Certainty({ shown, primitives }: { shown: ModelScene; primitives: readonly PrimitiveInfo[] }): JSX.Element {
  const errors = errorsOf(shown);
  if (!errors) return <>…</>;
  const loose = primitives.flatMap((primitive, index) => (isLoose(primitive, errors[index]) ? [{ primitive, index }] : []));
  const table = (
    <button type="button" class="link" onClick={() => goToPanel("primitives")}>
      standard error
    </button>
  );
  if (loose.length === 0) return <>The points tell every surface; each number has its {table}.</>;
  return (
    <>
      The points do not tell {loose.length === 1 ? "the surface" : "the surfaces"} of{" "}
      {loose.slice(0, NAMED).map(({ primitive, index }, at) => (
        <span key={index}>
          {at > 0 && ", "}
          <button type="button" class="link" onClick={() => (selectedPrimitive.value = { side: "prediction", index })}>
            {primitive.number} ({(primitive.type ?? "other").toLowerCase()})
          </button>
        </span>
      ))}
      {loose.length > NAMED && ` and ${loose.length - NAMED} more`}: very different ones fit as well. Each number of the others has
      its {table}.
    </>
  );
}

/** More would not be read. */
const NAMED = 6;

interface Prospects {
  readonly primitives: readonly PrimitiveInfo[];
  readonly noise: NoiseInfo | undefined;
  /** Share of the points that are in none. */
  readonly left: number;
  readonly points: number;
}

function Next({ primitives, noise, left, points }: Prospects): JSX.Element {
  const small = primitives.filter(({ size }) => size < SMALL * points).length;
  const ways = [
    noise?.source === "measured" && noise.deviation > 0 && "Where the noise of the scanner is known, give it under Noise.",
    small > 0 && `${format.plural(small, "primitive")} of less than ${format.share(SMALL)} of the points: raise Smallest if they are none.`,
    left > MUCH && "If too much was left out, raise Tolerance.",
    // Clouds with noise are judged by both methods alike.
    noise?.deviation === 0 && "Fit with the other method: what both find is there.",
  ].filter((way) => way !== false);
  return (
    <>
      {ways.join(" ")}{" "}
      <button type="button" class="link" onClick={() => (colourMode.value = "distance")}>
        Colour by distance
      </button>{" "}
      to see where a surface does not fit.
    </>
  );
}

/** How many points no primitive lists. */
function leftOut({ indices }: SegmentationScene, points: number): number {
  const listed = new Uint8Array(points);
  for (const index of indices) listed[index] = 1;
  let left = points;
  for (const one of listed) left -= one;
  return left;
}

function showLeftOut(primitives: readonly PrimitiveInfo[]): void {
  setHidden(
    primitives.map((_, index) => ({ side: "prediction", index })),
    true,
  );
}

function diagonalOf(model: string | undefined): number | undefined {
  const status = modelById(model)?.status;
  return status?.kind === "scored" ? status.result.info.bounds?.diagonal : undefined;
}

function noiseWords({ deviation, source, kind, step }: NoiseInfo, diagonal: number | undefined): string {
  if (deviation === 0) return "None: the points lie exactly on their surfaces.";
  const share = diagonal ? `, ${format.share(deviation / diagonal)} of the diagonal` : "";
  const how = { given: "as given", measured: "measured", tolerance: "by the tolerance given" }[source];
  const what = {
    exact: "",
    scattered: " Points are off at random.",
    rounded: ` Coordinates are rounded to steps of ${format.length(step)}.`,
    mixed: " Some points are exact and others not.",
    everywhere: " Some points lie on no surface at all.",
  }[kind ?? "exact"];
  return `${format.length(deviation)} in units of the file${share}, ${how}.${what}`;
}
