// Lesson: from a drawing to a score.

import type { JSX } from "preact";
import { useSignal, useSignalEffect } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { FITTERS } from "../../../generated/declared/fitters.js";
import { download } from "../../export/download";
import * as format from "../../ui/format";
import { Choice } from "../../ui/choice";
import { LiveView } from "../../view/live-view";
import { segmentTable } from "../../view/palette";
import type { PointView } from "../../view/point-view";
import { Standpoint } from "../../view/types";
import { LessonFrame } from "../frame";
import { Opening } from "../opening";
import { useFollower, useSession, type Session } from "../session";
import { step } from "../steps";
import * as state from "./state";
import { STEPS, type CadStep } from "./steps";

export default function CadLesson(): JSX.Element {
  const start = useSession(state.open);
  useEffect(() => state.close, []);
  return (
    <LessonFrame title="From a drawing to a score" steps={STEPS}>
      <Opening start={start}>{(session) => <Workbench session={session} />}</Opening>
    </LessonFrame>
  );
}

function shown(): CadStep | undefined {
  return STEPS[Math.min(step.value, STEPS.length) - 1];
}

/** Nothing of a millimetre, half a per cent, and steps between that show. */
const NOISE = { most: 0.5, step: 0.05 } as const;
const POINTS = { least: 500, most: 8000, step: 500 } as const;
const MOST_VIEWS = 8;

function Workbench({ session }: { session: Session }): JSX.Element {
  const view = useSignal<PointView | undefined>(undefined);
  const sample = useRef(state.sampler(session));
  const begun = useRef<unknown>(undefined);
  const framed = useRef<PointView | undefined>(undefined);
  const current = shown();
  const has = (tool: CadStep["tools"][number]) => current?.tools.includes(tool) === true;
  const change = (part: Partial<state.How>) => {
    state.how.value = { ...state.how.value, ...part };
    session.run(sample.current);
  };

  // Every step begins with points of its own.
  useFollower(() => {
    const now = shown();
    if (!now || begun.current === now) return;
    begun.current = now;
    state.how.value = now.begins;
    session.run(sample.current);
  });

  useSignalEffect(() => {
    const [drawn, model] = [view.value, state.part.value];
    if (!drawn || !model) return;
    const { camera } = drawn;
    drawn.setCloud(model.positions);
    if (framed.current === drawn) drawn.setCamera(camera);
    else {
      drawn.lookFrom(Standpoint.Isometric, false);
      framed.current = drawn;
    }
    const count = model.positions.length / 3;
    label(drawn, 0, count, model.lists.members);
    label(drawn, 1, count, state.segmentation.value?.members ?? []);
  });

  const { points, spread, views, noise } = state.how.value;
  const compared = state.segmentation.value !== undefined;
  const there = state.part.value !== undefined;

  // Two pictures have half the room of one.
  useEffect(() => {
    if (there) view.value?.fit(false);
  }, [compared, there, view.value]);

  return (
    <>
      <LiveView
        label={compared ? "The plate: on the left its faces, on the right what was found" : "The plate, a colour for each face"}
        layout={compared ? { kind: "split" } : { kind: "single", side: 0 }}
        apart
        onView={(made) => (view.value = made)}
      >
        {compared && (
          <>
            <span class="side-name left">Faces</span>
            <span class="side-name right">Found</span>
          </>
        )}
        {state.busy.value && <p class="canvas-state">The engine is at work…</p>}
      </LiveView>
      <div class="lesson-tools">
        <label>
          Points{" "}
          <input type="range" min={POINTS.least} max={POINTS.most} step={POINTS.step} value={points} onInput={(event) => change({ points: Number(event.currentTarget.value) })} />
          <output>{format.integer(points)}</output>
        </label>
        {has("spread") && <Choice label="Spread" value={spread} options={[["even", "even"], ["random", "random"], ["scan", "scan"]]} onChange={(next) => change({ spread: next })} />}
        {has("spread") && spread === "scan" && (
          <label>
            Viewpoints{" "}
            <input type="range" min="1" max={MOST_VIEWS} value={views} onInput={(event) => change({ views: Number(event.currentTarget.value) })} />
            <output>{views}</output>
          </label>
        )}
        {has("noise") && (
          <label>
            Noise{" "}
            <input type="range" min="0" max={NOISE.most} step={NOISE.step} value={100 * noise} onInput={(event) => change({ noise: Number(event.currentTarget.value) / 100 })} />
            <output>{(100 * noise).toFixed(2)} %</output>
          </label>
        )}
        {has("fit") && (
          <>
            <Choice label="Method" value={state.method.value} options={FITTERS.map(({ name, title }) => [name, title] as const)} onChange={(next) => (state.method.value = next)} />
            <button type="button" class="primary" disabled={state.busy.value} onClick={() => session.run(() => state.fit(session))}>
              Fit the points
            </button>
          </>
        )}
        {has("back") && (
          <>
            <button type="button" class="primary" disabled={state.busy.value || !compared} onClick={() => session.run(() => state.goBack(session))}>
              Write and read again
            </button>
            <button
              type="button"
              disabled={state.written.value === undefined}
              onClick={() => download(`${state.NAME}_found.step`, new Blob([state.written.value?.text ?? ""]))}
            >
              Save the STEP file
            </button>
          </>
        )}
      </div>
    </>
  );
}

function label(view: PointView, side: 0 | 1, count: number, lists: readonly Uint32Array[]): void {
  const labels = new Uint32Array(count);
  lists.forEach((list, place) => list.forEach((point) => (labels[point] = place + 1)));
  view.setLabels(side, labels);
  view.setColours(side, segmentTable(lists.length));
  view.colourByLabel(side);
}
