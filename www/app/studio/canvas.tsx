// The case in the view, and the lasso that lies over it.

import type { JSX } from "preact";
import { effect, useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { isDark } from "../state/settings";
import * as format from "../ui/format";
import { LiveView } from "../view/live-view";
import { bytes, segmentColour, UNSEGMENTED } from "../view/palette";
import type { PointView } from "../view/point-view";
import { LookFrom } from "../view/look-from";
import type { MadeCase, Weight } from "../../worker/studio";
import { isGenerated, type Case } from "./case";
import { LassoLayer } from "./lasso-layer";
import { vanished } from "./missing-section";
import { ask, failure, made, makeOffered, making, offered, stop } from "./state";
import { thinness } from "./thin";
import { followBall, inBall, placeBallOn, tool } from "./tools";

export function Canvas(): JSX.Element {
  const view = useSignal<PointView | undefined>(undefined);
  const drawn = view.value;
  useEffect(() => drawn && show(drawn), [drawn]);
  useEffect(followBall, []);
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
        <Trouble />
      </LiveView>
    </div>
  );
}

/** Why the case cannot be made, or what is wrong with it. */
function Trouble(): JSX.Element | null {
  if (failure.value !== undefined) {
    return (
      <p class="studio-failure" role="alert">
        {failure.value}
      </p>
    );
  }
  if (offered.value) return <Offer {...offered.value} />;
  const { of, result } = made.value ?? {};
  if (!of || !isGenerated(of) || !result?.truth) return null;
  const warning = thinness(result.thin, result.truth.primitives.length);
  return warning === undefined ? null : (
    <p class="studio-warning" role="status">
      {warning}
    </p>
  );
}

/** What a link's case takes to be made, before it is. */
function Offer({ of, weight }: { of: Case; weight: Weight | undefined }): JSX.Element {
  const parts = [
    weight && `about ${format.plural(Number(weight.points.toPrecision(2)), "point")}`,
    of.base.kind === "blocks" && format.plural(of.base.blocks.length, "block"),
    of.cuts.length > 0 && format.plural(of.cuts.length, "cut"),
  ];
  return (
    <div class="studio-offer" role="alert">
      <p>
        The case of this link takes {weight ? `roughly ${format.duration(1000 * weight.seconds)}` : "longer than could be found out"} to make:{" "}
        {parts.filter(Boolean).join(", ")}. It can be stopped at any moment.
      </p>
      <button type="button" onClick={makeOffered}>
        Make it
      </button>
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

/** Normals of more points would keep the next change waiting. */
const SHADED_AT_MOST = 100_000;

/** Has the points drawn as a surface once their normals are there, unless the case is another by then. */
function shade(view: PointView, of: MadeCase): void {
  if (of.positions.length / 3 > SHADED_AT_MOST) return;
  // Without normals the points are drawn all the same.
  ask((engine) => engine.normals()).then((normals) => made.peek()?.result === of && view.setNormals(normals), () => undefined);
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
      shade(view, result);
      // A change of the same part leaves the view where it is.
      const now = result.centre.map((coordinate) => coordinate.toPrecision(3)).join(" ");
      if (now === centre) view.setCamera(camera);
      centre = now;
    }),
    effect(labels),
    view.on("click", (hit) => {
      if (tool.value === "ball" && hit) placeBallOn(hit.index);
    }),
  ];
  return () => ends.forEach((end) => end());
}
