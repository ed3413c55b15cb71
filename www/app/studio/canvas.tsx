// The case in the view, and the lasso that lies over it.

import type { JSX } from "preact";
import { useSignal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { effect } from "@preact/signals";
import { isDark } from "../state/settings";
import * as format from "../ui/format";
import { LiveView } from "../view/live-view";
import { bytes, segmentColour, UNSEGMENTED } from "../view/palette";
import type { PointView } from "../view/point-view";
import { LookFrom } from "../view/look-from";
import { depthOf, lassoOf } from "./lasso";
import { vanished } from "./missing-section";
import { failure, made, making, stop } from "./state";
import { cutAway, inBall, placeBall, pointAt, reach, tool } from "./tools";

type Corner = readonly [number, number];

export function Canvas(): JSX.Element {
  const view = useSignal<PointView | undefined>(undefined);
  const drawn = view.value;
  useEffect(() => drawn && show(drawn), [drawn]);
  return (
    <div class="studio-view">
      <div class="picture-tools">
        <LookFrom view={drawn} />
        <button type="button" disabled={!drawn} title="Bring all points into the view (0, while the view has the focus)" onClick={() => drawn?.fit()}>
          Frame all
        </button>
        <Standing />
      </div>
      <LiveView
        label="The points of the case"
        layout={{ kind: "single", side: 0 }}
        onView={(created) => (view.value = created)}
      >
        {tool.value === "lasso" && view.value && <LassoLayer view={view.value} />}
        {failure.value !== undefined && (
          <p class="studio-failure" role="alert">
            {failure.value}
          </p>
        )}
      </LiveView>
    </div>
  );
}

/** What there is, in a sentence. */
function Standing(): JSX.Element {
  const result = made.value?.result;
  const lost = result?.cuts.flatMap((cut) => cut.vanished) ?? [];
  return (
    <>
      <p role="status">
        {making.value
          ? "Making it…"
          : result &&
            `${format.plural(result.positions.length / 3, "point")}, ` +
              (result.truth ? format.plural(result.truth.primitives.length, "primitive") : "no ground truth") +
              (lost.length > 0 ? `; ${vanished(lost)}` : "")}
      </p>
      {making.value && (
        <button type="button" onClick={stop}>
          Stop
        </button>
      )}
    </>
  );
}

/** Keeps a view showing the case for as long as the view lives. */
function show(view: PointView): () => void {
  let centre = "";
  const labels = () => {
    const result = made.value?.result;
    if (!result) return;
    const { positions, truth } = result;
    const primitives = truth?.primitives ?? [];
    const label = new Uint32Array(positions.length / 3);
    primitives.forEach((_, place) => {
      for (let at = truth?.offsets[place] ?? 0; at < (truth?.offsets[place + 1] ?? 0); at += 1) {
        label[truth?.indices[at] ?? 0] = place + 1;
      }
    });
    for (const point of inBall.value) label[point] = primitives.length + 1;
    view.setLabels(0, label);
    // A primitive keeps its colour when others vanish.
    const colours = primitives.map(({ number }) => segmentColour(number - 1));
    view.setColours(0, bytes([UNSEGMENTED, ...colours, isDark() ? "#ffffff" : "#000000"]));
  };
  const ends = [
    effect(() => {
      const result = made.value?.result;
      if (!result) return;
      const { camera } = view;
      view.setCloud(result.positions);
      view.colourByLabel(0);
      // A change of the same part leaves the view where it is.
      const now = result.centre.map((coordinate) => coordinate.toPrecision(3)).join(" ");
      if (now === centre) view.setCamera(camera);
      centre = now;
    }),
    effect(labels),
    view.on("click", (hit) => {
      const place = hit && pointAt(hit.index);
      if (tool.value === "ball" && place) placeBall({ centre: place });
    }),
  ];
  return () => ends.forEach((end) => end());
}

function LassoLayer({ view }: { view: PointView }): JSX.Element {
  const curve = useSignal<readonly Corner[]>([]);
  const layer = useRef<HTMLDivElement>(null);

  useEffect(() => {
    const drop = (event: KeyboardEvent) => {
      if (event.key === "Escape") curve.value = [];
    };
    window.addEventListener("keydown", drop);
    return () => window.removeEventListener("keydown", drop);
  }, [curve]);

  const end = () => {
    const corners = curve.value;
    curve.value = [];
    const result = made.value?.result;
    const { clientWidth: width, clientHeight: height } = view.canvas;
    if (!result || making.value || height === 0) return;
    const lasso = lassoOf(corners, { width, height, camera: view.camera, centre: result.centre });
    if (!lasso) return;
    const hit = view.pointsIn(0, { kind: "polygon", corners }, reach.value === "seen");
    if (hit.length === 0) return;
    if (reach.value === "through") return cutAway(lasso);
    // A little more than the deepest: what is seen must not stay for want of a digit.
    const depths = Array.from(hit, (index) => depthOf(lasso, pointAt(index) ?? lasso.target));
    const deepest = depths.reduce((most, depth) => Math.max(most, depth), -Infinity);
    cutAway({ ...lasso, depth: deepest + view.spacing / 4 });
  };

  return (
    <div
      ref={layer}
      class="lasso"
      onPointerDown={(event) => {
        if (event.button !== 0) return;
        event.currentTarget.setPointerCapture(event.pointerId);
        curve.value = [[event.offsetX, event.offsetY]];
      }}
      onPointerMove={({ offsetX, offsetY }) => {
        if (curve.value.length > 0) curve.value = [...curve.value, [offsetX, offsetY]];
      }}
      onPointerUp={end}
      onPointerCancel={() => (curve.value = [])}
      onWheel={(event) => view.zoom(Math.exp(-event.deltaY * 0.0015), event.offsetX, event.offsetY)}
    >
      <svg aria-hidden="true">
        <polygon points={curve.value.map((corner) => corner.join(",")).join(" ")} />
      </svg>
    </div>
  );
}
