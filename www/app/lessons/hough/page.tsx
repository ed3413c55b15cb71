// Lesson: the Hough transform.

import type { JSX } from "preact";
import { useSignal, useSignalEffect } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { bytes, rgb, segmentColour, segmentTable, UNSEGMENTED } from "../../view/palette";
import { LiveView } from "../../view/live-view";
import type { PointView } from "../../view/point-view";
import { LabelState, Standpoint } from "../../view/types";
import * as format from "../../ui/format";
import { Choice } from "../../ui/choice";
import { LessonFrame } from "../frame";
import { Opening } from "../opening";
import { useSession, type Session } from "../session";
import { step } from "../steps";
import { Accumulator } from "./accumulator";
import { Persistence } from "./persistence";
import * as state from "./state";
import { STEPS, type HoughStep } from "./steps";

const VOTER = segmentColour(2);
const SURFACE = segmentColour(0);
const NOTHING = new Uint32Array();
const NO_HEIGHTS = new Float32Array();

export default function HoughLessonPage(): JSX.Element {
  const start = useSession(state.openAnew);
  return (
    <LessonFrame title="The Hough transform" steps={STEPS}>
      <Opening start={start}>{(session) => <Workbench session={session} />}</Opening>
    </LessonFrame>
  );
}

function Workbench({ session }: { session: Session }): JSX.Element {
  const view = useSignal<PointView | undefined>(undefined);
  const relief = useSignal(false);
  const current = STEPS[Math.min(step.value, STEPS.length) - 1];
  // Reads the step anew, so that effects follow it.
  const has = (tool: HoughStep["tools"][number]) => STEPS[Math.min(step.value, STEPS.length) - 1]?.tools.includes(tool) === true;

  useSignalEffect(() => {
    const shown = state.part.value;
    const drawn = view.value;
    if (!drawn || !shown) return;
    drawn.setCloud(shown.positions);
    drawn.setNormals(shown.normals);
    drawn.colourByLabel(0);
    drawn.lookFrom(Standpoint.Isometric, false);
    drawn.turn(0, 0.35);
    drawn.fit(false);
  });

  useSignalEffect(() => {
    const shown = state.part.value;
    const drawn = view.value;
    if (!drawn || !shown) return;
    const found = has("segment") ? state.segmentation.value : undefined;
    const labels = new Uint32Array(shown.positions.length / 3);
    // Points that did not vote step back; faded points cannot be clicked.
    const apart = !found && !has("point") && state.cellInfo.value !== undefined && !has("vote") && !has("segment");
    drawn.setStates(0, apart ? [LabelState.Faded] : []);
    if (found) {
      found.members.forEach((list, place) => list.forEach((index) => (labels[index] = place + 1)));
      drawn.setColours(0, segmentTable(found.members.length));
      drawn.setPatches([]);
    } else {
      const polished = has("peaks") ? state.polished.value : undefined;
      const info = has("vote") || has("segment") ? undefined : state.cellInfo.value;
      const patch = polished?.patch ?? info?.patch;
      (polished?.support ?? info?.voters ?? NOTHING).forEach((index) => (labels[index] = 1));
      if (has("point") && state.point.value !== undefined) labels[state.point.value] = 2;
      drawn.setColours(0, bytes([UNSEGMENTED, VOTER, "#e000b8"]));
      drawn.setPatches(patch ? [{ side: 0, colour: rgb(SURFACE), ...patch }] : []);
    }
    drawn.setLabels(0, labels);
  });

  useEffect(() => {
    const drawn = view.value;
    if (!drawn || !has("point")) return;
    return drawn.on("click", (hit) => {
      if (hit) session.run(() => state.choosePoint(session, hit.index));
    });
  }, [view.value, current, session]);

  const { slice } = state;
  const heights = current?.shows === "all" ? state.all.value : current?.shows === "voted" ? state.heights.value : NO_HEIGHTS;
  const top = state.all.value.reduce((most, votes) => Math.max(most, votes), 0);
  const chooseCell = (index: number) => session.run(() => (has("peaks") ? state.polish(session, index) : state.chooseCell(session, index)));
  const marked = has("threshold") || has("peaks") ? state.maxima.value : [];
  return (
    <>
      <div class="lesson-pair">
        <LiveView label="The part" layout={{ kind: "single", side: 0 }} onView={(made) => (view.value = made)}>
          {state.busy.value && <p class="canvas-state">The engine is at work…</p>}
        </LiveView>
        <div class="accumulator-side">
          {slice.value && (
            <Accumulator
              slice={slice.value}
              heights={heights}
              top={top}
              lit={has("point") ? state.gamma.value : NOTHING}
              chosen={state.cell.value}
              maxima={marked}
              relief={relief.value}
              onCell={chooseCell}
            />
          )}
          {has("threshold") && state.maxima.value.length > 0 && (
            <Persistence maxima={state.maxima.value} share={state.share.value} chosen={state.cell.value} onCell={chooseCell} />
          )}
        </div>
      </div>
      <div class="lesson-tools">
        <Choice
          label="Family"
          value={state.family.value}
          options={state.FAMILIES.map((each) => [each, each] as const)}
          onChange={(next) => session.run(() => state.open(session, next))}
        />
        <Choice
          label="Landscape"
          value={relief.value ? "relief" : "map"}
          options={[["map", "Map"], ["relief", "Relief"]]}
          onChange={(next) => (relief.value = next === "relief")}
        />
        {has("point") && (
          <button type="button" onClick={() => session.run(() => state.choosePoint(session, another()))}>
            Another point
          </button>
        )}
        {has("vote") && <Voting session={session} />}
        {has("threshold") && (
          <label>
            Threshold{" "}
            <input
              type="range"
              min="0"
              max="100"
              value={Math.round(state.share.value * 100)}
              onInput={(event) => {
                const next = Number(event.currentTarget.value) / 100;
                session.run(() => state.setShare(session, next));
              }}
            />
            <output>{Math.round(state.share.value * 100)} %</output>
          </label>
        )}
        {has("peaks") && <Peaks session={session} />}
        {has("segment") && (
          <button type="button" class="primary" disabled={state.busy.value} onClick={() => session.run(() => state.segment(session))}>
            Run the Hough fitter
          </button>
        )}
      </div>
    </>
  );
}

/** The next point in the order of voting. */
function another(): number {
  const order = state.order(state.pointCount());
  const at = state.point.value === undefined ? -1 : order.indexOf(state.point.value);
  return order[(at + 1) % order.length] ?? 0;
}

const calm = matchMedia("(prefers-reduced-motion: reduce)");
/** Share of the points that votes between two pictures of the animation. */
const PACE = 0.02;

function Voting({ session }: { session: Session }): JSX.Element {
  const playing = useSignal(false);
  const count = state.pointCount();
  const to = (next: number) => session.run(() => state.vote(session, next));

  useSignalEffect(() => {
    if (!playing.value) return;
    if (state.voted.value >= count) {
      playing.value = false;
      return;
    }
    const timer = setTimeout(() => to(state.voted.peek() + Math.ceil(count * (calm.matches ? 0.25 : PACE))), calm.matches ? 600 : 40);
    return () => clearTimeout(timer);
  });

  return (
    <div class="row">
      <button type="button" onClick={() => to(0)}>
        None
      </button>
      <button type="button" onClick={() => to(state.voted.value + 1)}>
        One more
      </button>
      <button type="button" onClick={() => to(state.voted.value + 100)}>
        A hundred more
      </button>
      <button type="button" onClick={() => to(count)}>
        All
      </button>
      <button type="button" aria-pressed={playing.value} disabled={state.voted.value >= count} onClick={() => (playing.value = !playing.value)}>
        {playing.value ? "Pause" : "Play"}
      </button>
      <output>
        {format.integer(state.voted.value)} of {format.integer(count)} have voted
      </output>
    </div>
  );
}

/** Peaks offered as buttons; more are found in the square. */
const MOST_PEAKS = 12;

function Peaks({ session }: { session: Session }): JSX.Element {
  const kept = state.maxima.value.filter((each) => each.kept).slice(0, MOST_PEAKS);
  return (
    <div class="row" role="group" aria-label="Peaks, most persistent first">
      {kept.map(({ cell, birth }, place) => (
        <button
          key={cell}
          type="button"
          aria-pressed={cell === state.cell.value}
          onClick={() => session.run(() => state.polish(session, cell))}
        >
          Peak {place + 1}: {birth}
        </button>
      ))}
    </div>
  );
}
