// Lesson: how to win by protocol.

import type { JSX } from "preact";
import { useComputed, useSignal, useSignalEffect } from "@preact/signals";
import { useRef } from "preact/hooks";
import { bytes, segmentColour, UNSEGMENTED } from "../../view/palette";
import { LiveView } from "../../view/live-view";
import type { PointView } from "../../view/point-view";
import { Standpoint } from "../../view/types";
import { Choice } from "../../ui/choice";
import * as format from "../../ui/format";
import { LessonFrame } from "../frame";
import { Opening } from "../opening";
import { useFollower, useSession, type Session } from "../session";
import { step } from "../steps";
import * as state from "./state";
import { STEPS } from "./steps";

export default function ProtocolsLesson(): JSX.Element {
  const start = useSession(state.open);
  return (
    <LessonFrame title="How to win by protocol" steps={STEPS}>
      <Opening start={start}>{(session) => <Workbench session={session} />}</Opening>
    </LessonFrame>
  );
}

function Workbench({ session }: { session: Session }): JSX.Element {
  const view = useSignal<PointView | undefined>(undefined);
  const partner = useSignal(0);
  const current = useComputed(() => STEPS[Math.min(step.value, STEPS.length) - 1]);
  const ask = useRef(state.asker(session));
  const begun = useRef<unknown>(undefined);

  // Every step begins with its own prediction.
  useFollower(() => {
    const now = current.value;
    if (!state.part.value || !now || begun.current === now) return;
    begun.current = now;
    state.begin(now.begins);
    partner.value = state.bySize.peek()[1] ?? 0;
  });

  useSignalEffect(() => {
    if (!state.part.value) return;
    void state.lists.value;
    session.run(ask.current);
  });

  useSignalEffect(() => {
    const [drawn, shown] = [view.value, state.part.value];
    if (!drawn || !shown) return;
    drawn.setCloud(shown.positions);
    drawn.setNormals(shown.normals);
    drawn.setLabels(0, labelsOf(shown.positions.length / 3, shown.lists.members));
    drawn.setColours(0, bytes([UNSEGMENTED, ...shown.lists.members.map((_, place) => segmentColour(place))]));
    drawn.colourByLabel(0);
    drawn.colourByLabel(1);
    drawn.lookFrom(Standpoint.Isometric, false);
    drawn.fit(false);
  });

  useSignalEffect(() => {
    const [drawn, shown] = [view.value, state.part.value];
    if (!drawn || !shown) return;
    const found = state.predicted.value;
    drawn.setLabels(1, labelsOf(shown.positions.length / 3, found.map(({ points }) => points)));
    // What is kept keeps its colour.
    drawn.setColours(1, bytes([UNSEGMENTED, ...found.map(({ place }) => segmentColour(place))]));
  });

  const most = Math.max(0, ...state.members.value.map(({ length }) => length));
  const largest = state.bySize.value;
  return (
    <>
      <LiveView label="A bracket: on the left the truth, on the right the prediction" layout={{ kind: "split" }} onView={(made) => (view.value = made)}>
        <span class="side-name left">Truth</span>
        <span class="side-name right">Prediction</span>
      </LiveView>
      <div class="lesson-tools">
        <label>
          Drop segments under{" "}
          <input type="range" min="0" max={most} value={state.least.value} onInput={(event) => (state.least.value = Number(event.currentTarget.value))} />
          <output>{format.plural(state.least.value, "point")}</output>
        </label>
        <Choice
          label="Points predicted"
          value={String(state.stride.value)}
          options={[["1", "all"], ["2", "every second"], ["3", "every third"]]}
          onChange={(next) => (state.stride.value = Number(next))}
        />
        <div class="row">
          <Segments label="Segment" places={largest} value={state.chosen.value} onChange={(place) => (state.chosen.value = place)} />
          <button type="button" onClick={() => state.toggle(state.chosen.value)}>
            {state.isDropped(state.chosen.value) ? "Take up" : "Drop"}
          </button>
          <button type="button" disabled={partner.value === state.chosen.value} onClick={() => state.merge(state.chosen.value, partner.value)}>
            Merge with
          </button>
          <Segments label="The other" places={largest} value={partner.value} onChange={(place) => (partner.value = place)} />
        </div>
        <div class="row">
          <button type="button" onClick={() => state.begin("truth")}>The truth</button>
          <button type="button" onClick={() => state.begin("largest")}>Largest only</button>
          <button type="button" onClick={() => state.begin("pairs")}>In pairs</button>
          <button type="button" onClick={() => state.begin("merged")}>Smaller half merged</button>
          <button type="button" onClick={() => state.begin("one")}>All as one</button>
        </div>
      </div>
    </>
  );
}

interface SegmentsProps {
  readonly label: string;
  readonly places: readonly number[];
  readonly value: number;
  readonly onChange: (place: number) => void;
}

function Segments({ label, places, value, onChange }: SegmentsProps): JSX.Element {
  const kind = (place: number) => state.part.value?.lists.primitives[place]?.type ?? "Other";
  return (
    <select aria-label={label} value={String(value)} onChange={(event) => onChange(Number(event.currentTarget.value))}>
      {places.map((place) => (
        <option key={place} value={String(place)}>
          {place + 1}: {kind(place)}, {format.plural(state.members.value[place]?.length ?? 0, "point")}
          {state.isDropped(place) ? " (dropped)" : ""}
        </option>
      ))}
    </select>
  );
}

function labelsOf(count: number, lists: readonly Uint32Array[]): Uint32Array {
  const labels = new Uint32Array(count);
  lists.forEach((list, place) => list.forEach((point) => (labels[point] = place + 1)));
  return labels;
}
