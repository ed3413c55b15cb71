// What the view shows of the shape itself: normals, which let it shade the points as a surface, and
// the patches of the selected primitive's fitted surface and its partners'. The engine makes both
// when they are wanted; they are drawn when they come, unless something else is wanted by then.

import { effect } from "@preact/signals";
import type { ModelSource } from "../../worker/protocol";
import { engine } from "../engine/client";
import { modelById } from "../state/models";
import { scene } from "../state/scene";
import { selectedModel, selectedPrimitive } from "../state/selection";
import { rgb, type Rgb } from "../view/palette";
import type { PointView } from "../view/point-view";
import type { Side, SurfacePatch } from "../view/types";
import { partnersOf, segmentationOf, segmentColours } from "./colouring";
import { sides, surfacesShown } from "./display";
import { reports } from "./reports";

/** Starts keeping normals and patches in step; the result ends it. */
export function linkSurfaces(view: PointView): () => void {
  let latest: object | undefined;
  let cloud: string | undefined;
  const ends = [
    effect(() => {
      const state = scene.value;
      const source = modelById(selectedModel.value)?.source;
      if (state.kind !== "ready" || source?.key !== state.scene.key || state.scene.cloud === cloud) return;
      const asked = state.scene.cloud;
      cloud = asked;
      engine
        .run((api) => api.normals(source))
        // Without normals the points are drawn all the same.
        .then((normals) => cloud === asked && view.setNormals(normals), () => undefined);
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
    cloud = undefined;
    for (const end of ends) end();
  };
}

interface Wanted {
  readonly source: ModelSource;
  readonly method: string | undefined;
  readonly side: Side;
  readonly place: number;
  readonly colour: Rgb;
}

function wantedPatches(): Wanted[] {
  const state = scene.value;
  const selected = selectedPrimitive.value;
  const source = modelById(selectedModel.value)?.source;
  if (!surfacesShown.value || !selected || state.kind !== "ready" || source?.key !== state.scene.key) return [];
  const { method, rival } = state.scene;
  const methods = { truth: undefined, prediction: method, rival: rival?.method };
  const partners = partnersOf(reports.value, selected);
  return sides.value.flatMap((shown, side): Wanted[] => {
    const [place, of] = [partners[shown], segmentationOf(state.scene, shown)];
    const colour = place === undefined ? undefined : segmentColours(shown, reports.value, of?.primitives.length ?? 0)[place + 1];
    if (place === undefined || colour === undefined || !of?.primitives[place]?.surface) return [];
    return [{ source, method: methods[shown], side: side as Side, place, colour: rgb(colour) }];
  });
}

async function made({ source, method, side, place, colour }: Wanted): Promise<SurfacePatch | undefined> {
  const mesh = await engine.run((api) => api.patch(source, place, method));
  return mesh && { side, colour, ...mesh };
}
