// Lesson: implicit and parametric.

import type { ComponentChildren, JSX } from "preact";
import { useSignal, useSignalEffect } from "@preact/signals";
import { useRef } from "preact/hooks";
import type { Forms, SurfaceSliders } from "../../../generated/engine/engine.js";
import { bytes, rgb, segmentColour, UNSEGMENTED } from "../../view/palette";
import { LiveView } from "../../view/live-view";
import type { PointView } from "../../view/point-view";
import type { SurfacePatch } from "../../view/types";
import { Swatch } from "../../ui/swatch";
import { Choice } from "../../ui/choice";
import { LessonFrame } from "../frame";
import { Opening } from "../opening";
import { useSession, type Session } from "../session";
import { step } from "../steps";
import { choose, factor, FAMILIES, follower, noise, predicted, sliders, truth, truthSliders, vectors } from "./state";
import { STEPS } from "./steps";

const PREDICTED = segmentColour(0);
const TRUE = segmentColour(1);

export default function FormsLesson(): JSX.Element {
  // Until the engine has answered once, sliders would move nothing.
  const start = useSession((begun) => follower(begun).forms());
  return (
    <LessonFrame title="Implicit and parametric" steps={STEPS}>
      <Opening start={start}>{(session) => <Workbench session={session} />}</Opening>
    </LessonFrame>
  );
}

function Workbench({ session }: { session: Session }): JSX.Element {
  const view = useSignal<PointView | undefined>(undefined);
  const follow = useRef(follower(session));
  const framed = useRef("");
  const current = STEPS[Math.min(step.value, STEPS.length) - 1];

  useSignalEffect(() => {
    void sliders.value;
    void truthSliders.value;
    session.run(follow.current.forms);
  });
  useSignalEffect(() => {
    if (vectors.value) session.run(follow.current.compare);
  });

  useSignalEffect(() => {
    const forms = predicted.value;
    const fixed = truth.value;
    const drawn = view.value;
    if (!drawn || !forms || !fixed) return;
    const both = STEPS[Math.min(step.value, STEPS.length) - 1]?.compares === true;
    const first = forms.points.length / 3;
    const points = new Float32Array(both ? forms.points.length + fixed.points.length : forms.points.length);
    points.set(forms.points);
    if (both) points.set(fixed.points, forms.points.length);
    const camera = drawn.camera;
    drawn.setCloud(points);
    drawn.setLabels(0, Uint32Array.from({ length: points.length / 3 }, (_, point) => (point < first ? 1 : 2)));
    drawn.setColours(0, bytes([UNSEGMENTED, PREDICTED, TRUE]));
    drawn.colourByLabel(0);
    drawn.setPatches([patchOf(forms, PREDICTED), ...(both ? [patchOf(fixed, TRUE)] : [])].filter((patch) => patch !== undefined));
    const frame = `${forms.surface.type} ${both}`;
    if (framed.current === frame) drawn.setCamera(camera);
    else drawn.fit(false);
    framed.current = frame;
  });

  const { type, at, tilt, heading, size, minor } = sliders.value;
  const set = (change: Partial<SurfaceSliders>) => (sliders.value = { ...sliders.value, ...change });
  const place = (axis: 0 | 1 | 2) => (value: number) => {
    const next = [...at] as [number, number, number];
    next[axis] = value;
    set({ at: next });
  };
  return (
    <>
      <LiveView label="The surface" layout={{ kind: "single", side: 0 }} onView={(made) => (view.value = made)} />
      <div class="lesson-tools">
        <Choice label="Family" value={type} options={FAMILIES.map((family) => [family, family] as const)} onChange={choose} />
        <Slider name="x" value={at[0]} range={[-1, 1]} onInput={place(0)} />
        <Slider name="y" value={at[1]} range={[-1, 1]} onInput={place(1)} />
        <Slider name="z" value={at[2]} range={[-1, 1]} onInput={place(2)} />
        {type !== "Sphere" && (
          <>
            <Slider name="Tilt of the axis, °" value={tilt} range={[0, 90]} by={1} onInput={(next) => set({ tilt: next })} />
            <Slider name="Heading, °" value={heading} range={[0, 360]} by={1} onInput={(next) => set({ heading: next })} />
          </>
        )}
        {type === "Cone" && <Slider name="Half-angle, °" value={size} range={[5, 70]} by={1} onInput={(next) => set({ size: next })} />}
        {(type === "Cylinder" || type === "Sphere") && <Slider name="Radius" value={size} range={[0.1, 1.2]} onInput={(next) => set({ size: next })} />}
        {type === "Torus" && (
          <>
            <Slider name="Major radius" value={size} range={[0.5, 1]} onInput={(next) => set({ size: next })} />
            <Slider name="Minor radius" value={minor} range={[0.05, 0.45]} onInput={(next) => set({ minor: next })} />
          </>
        )}
        <button type="button" onClick={() => choose(type)}>
          Put back
        </button>
        {current?.factors === true && (
          <Choice
            label="Implicit vector times"
            value={String(factor.value)}
            options={[["1", "1"], ["-1", "−1"], ["2.5", "2.5"], ["-0.1", "−0.1"]]}
            onChange={(next) => (factor.value = Number(next))}
          />
        )}
        {current?.noises === true && <NoiseTools />}
        {current?.compares === true && (
          <p class="lesson-legend">
            <span>
              <Swatch colour={PREDICTED} />
              predicted
            </span>
            <span>
              <Swatch colour={TRUE} />
              true
            </span>
          </p>
        )}
      </div>
    </>
  );
}

function NoiseTools(): JSX.Element {
  const terms = truth.value?.terms ?? [];
  return (
    <>
      <label>
        Entry{" "}
        <select value={String(noise.value.entry)} onChange={(event) => (noise.value = { ...noise.value, entry: Number(event.currentTarget.value) })}>
          {terms.map((term, place) => (
            <option key={term} value={String(place)}>
              {term}
            </option>
          ))}
        </select>
      </label>
      <Choice
        label="is"
        value={String(noise.value.size)}
        options={[["0", "left alone"], ["1e-18", "∓10⁻¹⁸"], ["0.00001", "∓10⁻⁵"]]}
        onChange={(next) => (noise.value = { ...noise.value, size: Number(next) })}
      />
    </>
  );
}

interface SliderProps {
  readonly name: ComponentChildren;
  readonly value: number;
  readonly range: readonly [number, number];
  readonly by?: number;
  readonly onInput: (value: number) => void;
}

function Slider({ name, value, range: [low, high], by = 0.01, onInput }: SliderProps): JSX.Element {
  return (
    <label>
      {name} <input type="range" min={low} max={high} step={by} value={value} onInput={(event) => onInput(Number(event.currentTarget.value))} />
      <output>{by < 1 ? value.toFixed(2) : value}</output>
    </label>
  );
}

function patchOf(forms: Forms, colour: string): SurfacePatch | undefined {
  return forms.patch && { side: 0, colour: rgb(colour), ...forms.patch };
}
