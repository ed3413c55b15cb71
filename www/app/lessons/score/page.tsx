// Lesson: what a score means.

import type { JSX } from "preact";
import { useComputed, useSignal, useSignalEffect } from "@preact/signals";
import { useRef } from "preact/hooks";
import { bytes, OUTCOME_COLOURS, segmentColour, UNSEGMENTED } from "../../view/palette";
import { LiveView } from "../../view/live-view";
import type { PointView } from "../../view/point-view";
import { Standpoint } from "../../view/types";
import { Swatch } from "../../ui/swatch";
import { Choice } from "../../ui/choice";
import { LessonFrame } from "../frame";
import { Opening } from "../opening";
import { useFollower, useSession, type Session } from "../session";
import { step } from "../steps";
import { NAMES } from "./figures";
import { grown, PREDICTIONS, put, shifted, shrunk, type Prediction } from "./selection";
import { active, begin, load, lookedAt, near, openAnew, painting, part, rest, score, scorer, shift, truth } from "./state";
import { STEPS } from "./steps";

const OUTCOMES = [UNSEGMENTED, OUTCOME_COLOURS.truePositive, OUTCOME_COLOURS.falsePositive, OUTCOME_COLOURS.falseNegative];
/** Truth and predictions must not look alike: predictions begin where the truth's colours end. */
const predictionColour = (place: number) => segmentColour(3 + place);

type Tool = "turn" | "paint" | "erase";

export default function ScoreLesson(): JSX.Element {
  const start = useSession(openAnew);
  return (
    <LessonFrame title="What a score means" steps={STEPS}>
      <Opening start={start}>{(session) => <Workbench session={session} />}</Opening>
    </LessonFrame>
  );
}

function Workbench({ session }: { session: Session }): JSX.Element {
  const view = useSignal<PointView | undefined>(undefined);
  const tool = useSignal<Tool>("paint");
  const radius = useSignal(18);
  const current = useComputed(() => STEPS[Math.min(step.value, STEPS.length) - 1]);
  const shows = useSignal<"outcome" | "prediction">("outcome");
  const rescore = useRef(scorer(session));
  const begun = useRef<unknown>(undefined);

  // Every step begins with its own painting.
  useFollower(() => {
    const now = current.value;
    if (!part.value || !now || begun.current === now) return;
    begun.current = now;
    lookedAt.value = now.looks;
    shows.value = now.shows;
    if (now.needs !== "rest" && rest.peek() > 0) session.run(() => load(session, 0));
    begin(now.begins);
  });

  useSignalEffect(() => {
    if (!part.value) return;
    void painting.value;
    void shift.value;
    session.run(rescore.current);
  });

  useSignalEffect(() => {
    const shown = part.value;
    const drawn = view.value;
    if (!drawn || !shown) return;
    drawn.setCloud(shown.positions);
    drawn.setNormals(shown.normals);
    const labels = new Uint32Array(shown.positions.length / 3);
    shown.lists.members.forEach((list, place) => list.forEach((point) => (labels[point] = place + 1)));
    drawn.setLabels(0, labels);
    drawn.setColours(0, bytes([UNSEGMENTED, ...shown.lists.members.map((_, place) => segmentColour(place))]));
    drawn.colourByLabel(0);
    drawn.colourByLabel(1);
    const own = shown.lists.members.slice(0, 2).map((_, place) => place + 1);
    // From before the opening and above, where no part of the niche hides another.
    drawn.lookFrom(Standpoint.Front, false);
    drawn.turn(0.3, 0.6);
    drawn.fitLabels(0, own, false);
    drawn.zoom(0.92);
  });

  useSignalEffect(() => {
    const shown = part.value;
    const drawn = view.value;
    if (!drawn || !shown) return;
    const outcome = shows.value === "outcome";
    drawn.setLabels(1, outcome ? outcomes() : predictions());
    drawn.setColours(1, bytes(outcome ? OUTCOMES : [UNSEGMENTED, ...PREDICTIONS.map((_, place) => predictionColour(place)), "#000000"]));
  });

  return (
    <>
      <LiveView
        label="A niche: on the left the truth, on the right the prediction"
        layout={{ kind: "split" }}
        onView={(made) => (view.value = made)}
      >
        <span class="side-name left">Truth</span>
        <span class="side-name right">{shows.value === "outcome" ? `Outcome for the ${NAMES[lookedAt.value]}` : "Prediction"}</span>
        <Brush view={view.value} tool={tool.value} radius={radius.value} />
      </LiveView>
      <div class="lesson-tools">
        <Choice
          label="Tool"
          value={tool.value}
          options={[["paint", "Paint"], ["erase", "Erase"], ["turn", "Turn the view"]]}
          onChange={(next) => (tool.value = next)}
        />
        <label>
          Brush <input type="range" min="4" max="60" value={radius.value} onInput={(event) => (radius.value = Number(event.currentTarget.value))} />
        </label>
        <Choice
          label="Prediction"
          value={String(active.value)}
          options={PREDICTIONS.map((name, place) => [String(place), name] as const)}
          swatch={(place) => predictionColour(Number(place))}
          onChange={(next) => (active.value = Number(next) as Prediction)}
        />
        <div class="row">
          <button type="button" onClick={() => (painting.value = grown(painting.value, near.value, active.value))}>
            Grow
          </button>
          <button type="button" onClick={() => (painting.value = shrunk(painting.value, near.value, active.value))}>
            Shrink
          </button>
          <button type="button" aria-label="Shift to −x" onClick={() => move(-1)}>
            Shift −x
          </button>
          <button type="button" aria-label="Shift to +x" onClick={() => move(1)}>
            Shift +x
          </button>
          <button type="button" onClick={() => (painting.value = put(painting.value, [...painting.value.keys()], active.value, false))}>
            Clear {PREDICTIONS[active.value]}
          </button>
        </div>
        <div class="row">
          <button type="button" onClick={() => begin("truth")}>The truth</button>
          <button type="button" onClick={() => begin("pieces")}>Wall in three</button>
          <button type="button" onClick={() => begin("one")}>All as one</button>
          {current.value?.needs === "shift" && <button type="button" onClick={stray}>One stray point</button>}
        </div>
        <Choice
          label="Right picture"
          value={shows.value}
          options={[["outcome", "Outcome"], ["prediction", "Prediction"]]}
          onChange={(next) => (shows.value = next)}
        />
        <Choice
          label="Looked at"
          value={String(lookedAt.value)}
          options={[["0", "Wall"], ["1", "Floor"]]}
          swatch={(place) => segmentColour(Number(place))}
          onChange={(next) => (lookedAt.value = Number(next))}
        />
        {current.value?.needs === "shift" && (
          <label>
            Surfaces moved by <input type="range" min="0" max="0.3" step="0.005" value={shift.value} onInput={(event) => (shift.value = Number(event.currentTarget.value))} />
            <output>{shift.value.toFixed(3)}</output>
          </label>
        )}
        {current.value?.needs === "rest" && (
          <Choice
            label="More points elsewhere"
            value={String(rest.value)}
            options={[["0", "none"], ["4000", "4,000"], ["40000", "40,000"]]}
            onChange={(next) => session.run(() => load(session, Number(next)))}
          />
        )}
        {shows.value === "outcome" && (
          <p class="lesson-legend">
            {["true negative", "true positive", "false positive", "false negative"].map((name, place) => (
              <span key={name}>
                <Swatch colour={OUTCOMES[place] ?? UNSEGMENTED} />
                {name}
              </span>
            ))}
          </p>
        )}
      </div>
    </>
  );
}

function move(way: 1 | -1): void {
  const positions = part.value?.positions;
  if (positions) painting.value = shifted(painting.value, near.value, positions, active.value, way);
}

/** Adds the wall's last point, at its upper rim, to the floor's prediction. */
function stray(): void {
  const last = truth.value[0]?.at(-1);
  if (last !== undefined) painting.value = put(painting.value, [last], 1, true);
}

/** Label of every point: 0 true negative, 1 true positive, 2 false positive, 3 false negative. */
function outcomes(): Uint32Array {
  const labels = new Uint32Array(painting.value.length);
  const matched = score.value?.report.primitives[lookedAt.value]?.match;
  const members = new Set(truth.value[lookedAt.value]);
  painting.value.forEach((bits, point) => {
    const predicted = matched !== null && matched !== undefined && (bits & (1 << (matched - 1))) !== 0;
    labels[point] = predicted ? (members.has(point) ? 1 : 2) : members.has(point) ? 3 : 0;
  });
  return labels;
}

/** Label of every point: 0 for none, 1 to 4 for one prediction, 5 for several. */
function predictions(): Uint32Array {
  const single = new Map([[0, 0], [1, 1], [2, 2], [4, 3], [8, 4]]);
  return Uint32Array.from(painting.value, (bits) => single.get(bits) ?? 5);
}

interface BrushProps {
  readonly view: PointView | undefined;
  readonly tool: Tool;
  readonly radius: number;
}

/** Lies over the view while it is painted on. */
function Brush({ view, tool, radius }: BrushProps): JSX.Element | null {
  const ring = useRef<HTMLElement>(null);
  if (tool === "turn" || !view) return null;
  const dab = (event: PointerEvent) => {
    const { offsetX: x, offsetY: y } = event;
    if (ring.current) {
      ring.current.style.left = `${x}px`;
      ring.current.style.top = `${y}px`;
    }
    if (event.buttons === 0) return;
    const side = view.sideAt(x, y) ?? 1;
    const points = view.pointsIn(side, { kind: "circle", x, y, radius });
    const own = near.value.length;
    painting.value = put(painting.value, points.filter((point) => point < own), active.value, tool === "paint");
  };
  return (
    <div
      class="brush"
      onPointerDown={(event) => {
        event.currentTarget.setPointerCapture(event.pointerId);
        dab(event);
      }}
      onPointerMove={dab}
      onWheel={(event) => view.zoom(Math.exp(-event.deltaY * 0.0015), event.offsetX, event.offsetY)}
    >
      <i ref={ring} style={{ width: `${2 * radius}px`, height: `${2 * radius}px` }} />
    </div>
  );
}
