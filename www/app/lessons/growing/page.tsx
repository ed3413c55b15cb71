// Lesson: primitive growing.

import type { JSX } from "preact";
import { useSignal, useSignalEffect } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { bytes, segmentColour, segmentTable, SEQUENTIAL, UNSEGMENTED } from "../../view/palette";
import { LiveView } from "../../view/live-view";
import type { PointView } from "../../view/point-view";
import { LabelState, Standpoint } from "../../view/types";
import * as format from "../../ui/format";
import { Choice } from "../../ui/choice";
import { LessonFrame } from "../frame";
import { Opening } from "../opening";
import { useFollower, useSession, type Session } from "../session";
import { step } from "../steps";
import { place } from "./histogram";
import * as state from "./state";
import { STEPS, type GrowingStep } from "./steps";

const CHOSEN = "#e000b8";
const GHOST = segmentColour(0);

export default function GrowingLessonPage(): JSX.Element {
  const start = useSession(state.open);
  return (
    <LessonFrame title="Primitive growing" steps={STEPS}>
      <Opening start={start}>{(session) => <Workbench session={session} />}</Opening>
    </LessonFrame>
  );
}

function shown(): GrowingStep | undefined {
  return STEPS[Math.min(step.value, STEPS.length) - 1];
}

function Workbench({ session }: { session: Session }): JSX.Element {
  const view = useSignal<PointView | undefined>(undefined);
  const setThreshold = useRef(state.thresholder(session));
  const move = useRef(state.mover(session));
  const framed = useRef<PointView | undefined>(undefined);
  const current = shown();
  const has = (tool: GrowingStep["tools"][number]) => current?.tools.includes(tool) === true;

  // What comes after growing is about the regions of a threshold that suits the part.
  useFollower(() => {
    const settled = shown()?.tools.includes("regions") === true;
    if (!settled || !state.part.value || state.eta.peek() === state.ETA.first) return;
    state.eta.value = state.ETA.first;
    session.run(() => setThreshold.current(state.ETA.first));
  });

  useSignalEffect(() => {
    void state.motion.value;
    void state.amount.value;
    session.run(move.current);
  });

  useSignalEffect(() => {
    const drawn = view.value;
    const model = state.part.value;
    const what = shown();
    if (!drawn || !model || !what) return;
    const own = model.positions.length / 3;
    const ghost = what.tools.includes("motion") ? state.ghost.value : new Float32Array();
    const positions = new Float32Array(model.positions.length + ghost.length);
    positions.set(model.positions);
    positions.set(ghost, model.positions.length);
    const camera = drawn.camera;
    drawn.setCloud(positions);
    // The copy that slides has none.
    drawn.setNormals(model.normals);
    if (framed.current === drawn) drawn.setCamera(camera);
    else {
      drawn.lookFrom(Standpoint.Isometric, false);
      drawn.fit(false);
      framed.current = drawn;
    }
    colour(drawn, what, own, positions.length / 3);
  });

  useEffect(() => {
    const drawn = view.value;
    if (!drawn || !has("regions")) return;
    return drawn.on("click", (hit) => {
      const label = hit && state.partition.value?.labels[hit.index];
      if (label !== undefined && label !== state.SHARP) session.run(() => state.choose(session, label));
    });
  }, [view.value, current, session]);

  const regions = (state.partition.value?.sizes ?? []).filter((size) => size >= state.CRUMB).slice(0, 24);
  return (
    <>
      <LiveView label="The part" layout={{ kind: "single", side: 0 }} onView={(made) => (view.value = made)}>
        {state.busy.value && <p class="canvas-state">The engine is at work…</p>}
      </LiveView>
      <div class="lesson-tools">
        {has("eta") && (
          <label>
            η{" "}
            <input
              type="range"
              min={state.ETA.least}
              max={state.ETA.most}
              step="0.01"
              value={state.eta.value}
              onInput={(event) => {
                const next = Number(event.currentTarget.value);
                state.eta.value = next;
                session.run(() => setThreshold.current(next));
              }}
            />
            <output>{state.eta.value.toFixed(2)}</output>
          </label>
        )}
        {has("growth") && (
          <>
            <label>
              Steps{" "}
              <input
                type="range"
                min="0"
                max={state.lastStep()}
                value={state.grown.value}
                onInput={(event) => (state.grown.value = Number(event.currentTarget.value))}
              />
              <output>{state.grown.value}</output>
            </label>
            <button type="button" onClick={() => (state.grown.value = Math.min(state.lastStep(), state.grown.value + 1))}>
              One step
            </button>
          </>
        )}
        {has("regions") && (
          <label>
            Region{" "}
            <select
              value={state.region.value === undefined ? "" : String(state.region.value)}
              onChange={(event) => {
                const { value } = event.currentTarget;
                if (value !== "") session.run(() => state.choose(session, Number(value)));
              }}
            >
              <option value="">none</option>
              {regions.map((size, at) => (
                <option key={at} value={String(at)}>
                  {at + 1}: {format.plural(size, "point")}
                </option>
              ))}
            </select>
          </label>
        )}
        {has("motion") && state.slippage.value && state.slippage.value.motions.length > 0 && (
          <>
            <Choice
              label="Motion"
              value={String(state.motion.value)}
              options={state.slippage.value.motions.map((name, at) => [String(at), `${at + 1}: ${name}`] as const)}
              onChange={(next) => (state.motion.value = Number(next))}
            />
            <label>
              Amount{" "}
              <input
                type="range"
                min="-1"
                max="1"
                step="0.02"
                value={state.amount.value}
                onInput={(event) => (state.amount.value = Number(event.currentTarget.value))}
              />
            </label>
          </>
        )}
        {has("split") && (
          <button
            type="button"
            class="primary"
            disabled={state.region.value === undefined || state.busy.value}
            onClick={() => session.run(() => state.split(session))}
          >
            Split the region
          </button>
        )}
        {has("segment") && (
          <button type="button" class="primary" disabled={state.busy.value} onClick={() => session.run(() => state.segment(session))}>
            Run the growing fitter
          </button>
        )}
      </div>
    </>
  );
}

/** Colours the part's `own` points and the ghost's after them, as the step shows them. */
function colour(view: PointView, what: GrowingStep, own: number, count: number): void {
  const partition = state.partition.value;
  const labels = new Uint32Array(count);
  if (what.shows === "variation") {
    const { variation } = state;
    view.setScalars(0, Float32Array.from(variation.value, place));
    view.setColourMap(0, SEQUENTIAL);
    view.setStates(0, []);
    view.setLabels(0, labels);
    view.colourByScalar(0, 0, 1);
    return;
  }
  const regionOf = (point: number) => partition?.labels[point] ?? state.SHARP;
  let table = bytes([UNSEGMENTED, CHOSEN]);
  if (what.shows === "sharp") {
    for (let point = 0; point < own; point += 1) labels[point] = regionOf(point) === state.SHARP ? 1 : 0;
  } else if (what.shows === "growth") {
    const steps = partition?.steps ?? new Uint32Array();
    for (let point = 0; point < own; point += 1) {
      const label = regionOf(point);
      if (label !== state.SHARP && (steps[point] ?? 0) <= state.grown.value) labels[point] = label + 1;
    }
    table = segmentTable(partition?.sizes.length ?? 0);
  } else if (what.shows === "segmentation") {
    const found = state.segmentation.value;
    found?.members.forEach((list, at) => list.forEach((point) => (labels[point] = at + 1)));
    table = segmentTable(found?.members.length ?? 0);
  } else if (what.shows === "pieces" && state.pieces.value) {
    state.pieces.value.forEach(({ support }, at) => support.forEach((point) => (labels[point] = at + 1)));
    table = segmentTable(state.pieces.value.length);
  } else {
    const chosen = state.region.value;
    const regions = partition?.sizes.length ?? 0;
    for (let point = 0; point < own; point += 1) {
      const label = regionOf(point);
      if (label === state.SHARP) continue;
      labels[point] = chosen === undefined ? label + 1 : label === chosen ? regions + 1 : 0;
    }
    for (let point = own; point < count; point += 1) labels[point] = regions + 2;
    table = new Uint8Array([...segmentTable(regions), ...bytes([CHOSEN, GHOST])]);
  }
  // The rest of the part would hide a region on its far side; hidden points cannot be clicked, so not while choosing.
  const apart = (what.tools.includes("motion") && state.region.value !== undefined) || (what.shows === "pieces" && state.pieces.value !== undefined);
  view.setStates(0, apart ? [LabelState.Hidden] : []);
  view.setLabels(0, labels);
  view.setColours(0, table);
  view.colourByLabel(0);
}
