// Keeps a view in step with the page's state: what is shown, how it is coloured, what stands out.

import { effect, signal } from "@preact/signals";
import { modelById } from "../state/models";
import { scene } from "../state/scene";
import { hoveredPrimitive, selectedPrimitive, type PrimitiveRef, type Side as SideName } from "../state/selection";
import { isDark } from "../state/settings";
import type { PointView } from "../view/point-view";
import { LabelState, type Side } from "../view/types";
import { brushed } from "./brush";
import { labelling, partnersOf, segmentationOf, table, type Labelling, type Shown } from "./colouring";
import { asideLooks, hidden, isolated, locked, restHidden } from "./isolation";
import { linkOutcomes, outcomes } from "./outcomes";
import { linkSurfaces } from "./surfaces";
import { awaitedCamera, restingCamera } from "./camera";
import { colourMode, eyeDome, pointSize, projection, shownBox, sides, unsegmentedShown } from "./display";
import { reports } from "./reports";

const SIDES = [0, 1] as const satisfies Side[];

/** Coordinates of as many points as are coloured within a frame. */
const AT_ONCE = 3 * 200_000;

/** The paper's figures are on white, and black must be seen on it. */
const PAPER = { background: "#ffffff", ink: "#000000" };
const DARK = { background: "#14181c", ink: "#ffffff" };

/** Starts keeping in step; the result ends it. */
export function link(view: PointView): () => void {
  let cloud: string | undefined;
  /** The latest colouring, which puts off what is left of those before. */
  let latest: object | undefined;
  /** How many labels either side has. */
  const counts = [signal(1), signal(1)] as const;
  const ends = [
    view.on("camera", () => (restingCamera.value = view.portableCamera)),
    effect(() => {
      const figure = colourMode.value === "figure";
      view.setTheme(isDark() && !figure ? DARK : PAPER);
    }),
    effect(() => view.setEyeDome(eyeDome.value === "on" ? 1 : 0)),
    effect(() => view.setPointSize({ unit: "spacing", value: pointSize.value })),
    effect(() => view.setProjection(projection.value)),
    effect(() => view.setClipBox(shownBox.value)),
    effect(() => {
      const state = scene.value;
      if (state.kind !== "ready") return;
      // Another method of the same model keeps the camera.
      if (state.scene.cloud !== cloud) {
        cloud = state.scene.cloud;
        view.setCloud(state.scene.positions);
      }
      const awaited = awaitedCamera.value;
      if (awaited && modelById(awaited.model)?.source.key === state.scene.key) {
        view.setPortableCamera(awaited.state);
        awaitedCamera.value = undefined;
      }
      const shown = shownNow();
      if (!shown) return;
      const [mode, names] = [colourMode.value, sides.value];
      const colourSide = (side: Side) => {
        const what = labelling(mode, names[side], shown);
        counts[side].value = what.colours.length;
        colour(view, side, what);
      };
      const own = (latest = {});
      if (state.scene.positions.length <= AT_ONCE) return SIDES.forEach(colourSide);
      // Of millions of points each side has a task of its own.
      void (async () => {
        for (const side of SIDES) {
          await pause();
          if (latest !== own) return;
          colourSide(side);
        }
      })();
    }),
    effect(() => {
      const shown = shownNow();
      if (!shown) return;
      for (const side of SIDES) {
        const own = states(sides.value[side], shown);
        view.setStates(side, shown.brushed ? withFaded(own, counts[side].value / 2) : own);
      }
    }),
  ];
  ends.push(linkOutcomes(), linkSurfaces(view));
  return () => {
    latest = undefined;
    for (const end of ends) end();
  };
}

/** Lets what waits for the page's thread have it. */
function pause(): Promise<void> {
  return new Promise((resolve) => setTimeout(resolve));
}

function shownNow(): Shown | undefined {
  const state = scene.value;
  if (state.kind !== "ready") return undefined;
  // Only one colouring depends on the selection; the others need not be made anew for it.
  const selected = colourMode.value === "outcome" ? selectedPrimitive.value : undefined;
  return { scene: state.scene, reports: reports.value, selected, outcomes: outcomes.value, brushed: brushed.value?.points };
}

function colour(view: PointView, side: Side, what: Labelling): void {
  view.setLabels(side, what.labels);
  view.setColours(side, table(what));
  if (what.scalars) {
    view.setScalars(side, what.scalars.values);
    view.colourByScalar(side, what.scalars.low, what.scalars.high);
  } else if (what.normals) {
    view.colourByNormal(side);
  } else {
    view.colourByLabel(side);
  }
}

/** The selected primitive and its partners stand out; what is hovered joins them. */
function states(side: SideName, shown: Shown): LabelState[] {
  const mode = colourMode.value;
  const zero = unsegmentedShown.value === "on" && !restHidden.value ? LabelState.Shown : LabelState.Hidden;
  // The outcome alone has colour; the rest of the object only tells where.
  if (mode === "outcome") return [zero === LabelState.Shown && selectedPrimitive.value ? LabelState.Faded : zero];
  if (mode === "figure" && side !== "truth") return [zero];
  const count = segmentationOf(shown.scene, side)?.primitives.length ?? 0;
  const selected = selectedPrimitive.value;
  const hovered = hoveredPrimitive.value;
  const aside = isolated.value ? LabelState.Hidden : LabelState.Faded;
  const rest = selected ? aside : LabelState.Shown;
  const all = new Array<LabelState>(count + 1).fill(rest);
  all[0] = zero === LabelState.Hidden ? zero : rest;
  const placeOf = (ref: PrimitiveRef | undefined) => ref && partnersOf(shown.reports, ref)[side];
  const raise = (ref: PrimitiveRef | undefined, state: LabelState) => {
    const place = placeOf(ref);
    if (place !== undefined) all[place + 1] = state;
  };
  raise(selected, LabelState.Shown);
  raise(hovered, LabelState.Highlighted);
  const gone = asideLooks.value === "faint" ? LabelState.Faded : LabelState.Hidden;
  for (const ref of hidden.value.values()) raise(ref, gone);
  for (const ref of locked.value.values()) {
    if (all[(placeOf(ref) ?? NaN) + 1] === LabelState.Shown) raise(ref, LabelState.Locked);
  }
  return all;
}

/** The states of so many labels, and of their second series for the points that do not stand out. */
function withFaded(own: readonly LabelState[], count: number): LabelState[] {
  const all = Array.from({ length: count }, (_, label) => own[label] ?? LabelState.Shown);
  return [...all, ...all.map((state) => (state === LabelState.Hidden ? state : LabelState.Faded))];
}
