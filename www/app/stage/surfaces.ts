// What the view shows of the shape itself: normals, which let it shade the points as a surface, and
// the patches of the selected primitive's fitted surface and its partner's. The engine makes both
// when they are wanted; they are drawn when they come, unless something else is wanted by then.

import { effect } from "@preact/signals";
import type { ModelSource, SegmentationScene } from "../../worker/protocol";
import { engine } from "../engine/client";
import { modelById } from "../state/models";
import { scene } from "../state/scene";
import { selectedModel, selectedPrimitive, selectedReports } from "../state/selection";
import { protocol } from "../state/settings";
import type { PointView } from "../view/point-view";
import type { Side, SurfacePatch } from "../view/types";
import { pairOf, segmentColours } from "./colouring";
import { surfacesShown } from "./display";

/** Starts keeping normals and patches in step; the result ends it. */
export function linkSurfaces(view: PointView): () => void {
  let latest: object | undefined;
  let positions: Float32Array | undefined;
  const ends = [
    effect(() => {
      const state = scene.value;
      const source = modelById(selectedModel.value)?.source;
      if (state.kind !== "ready" || source?.key !== state.scene.key || state.scene.positions === positions) return;
      const cloud = state.scene.positions;
      positions = cloud;
      engine
        .run((api) => api.normals(source))
        // Without normals the points are drawn all the same.
        .then((normals) => positions === cloud && view.setNormals(normals), () => undefined);
    }),
    effect(() => {
      const wanted = wantedPatches();
      const request = {};
      latest = request;
      Promise.all(wanted.map(made)).then(
        (patches) => latest === request && view.setPatches(patches.filter((patch) => patch !== undefined)),
        () => latest === request && view.setPatches([]),
      );
    }),
  ];
  return () => {
    latest = undefined;
    positions = undefined;
    for (const end of ends) end();
  };
}

interface Wanted {
  readonly source: ModelSource;
  readonly method: string | undefined;
  readonly side: Side;
  readonly place: number;
  readonly colour: string;
}

function wantedPatches(): Wanted[] {
  const state = scene.value;
  const selected = selectedPrimitive.value;
  const source = modelById(selectedModel.value)?.source;
  if (!surfacesShown.value || !selected || state.kind !== "ready" || source?.key !== state.scene.key) return [];
  const { truth, prediction, method } = state.scene;
  const report = selectedReports.value?.[protocol.value];
  const alone = selected.side === "truth" ? { truth: selected.index } : { match: selected.index };
  const pair: { truth?: number; match?: number } = report ? pairOf(report, selected) : alone;
  const shown = { scene: state.scene, report, selected };
  const patch = (side: Side, place: number | undefined, of: SegmentationScene | undefined): Wanted[] => {
    const colour = place === undefined ? undefined : segmentColours(side, shown, of?.primitives.length ?? 0)[place + 1];
    if (place === undefined || colour === undefined || !of?.primitives[place]?.surface) return [];
    return [{ source, method: side === 0 ? undefined : method, side, place, colour }];
  };
  return [...patch(0, pair.truth, truth), ...patch(1, pair.match, prediction)];
}

async function made({ source, method, side, place, colour }: Wanted): Promise<SurfacePatch | undefined> {
  const mesh = await engine.run((api) => api.patch(source, place, method));
  return mesh && { side, colour, ...mesh };
}
