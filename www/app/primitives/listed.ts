// The primitives in view, by whose they are and by type: each once, the true one for its matches.

import { computed } from "@preact/signals";
import { SURFACE_TYPES } from "../../generated/declared/surface-types.js";
import { segmentationOf, segmentColours } from "../stage/colouring";
import { standsFor } from "../stage/isolation";
import { reports } from "../stage/reports";
import { scene } from "../state/scene";
import type { PrimitiveRef, Side } from "../state/selection";
import { UNSEGMENTED } from "../view/palette";

export interface Listed {
  readonly ref: PrimitiveRef;
  /** As a file counts it. */
  readonly number: number;
  /** Whose it is, its number and type. */
  readonly name: string;
  readonly points: number;
  readonly colour: string;
}

export interface Kind {
  /** `Plane`, or `other`. */
  readonly type: string;
  /** `Planes`. */
  readonly title: string;
  readonly primitives: readonly Listed[];
}

export interface Whose {
  readonly side: Side;
  readonly title: string;
  readonly kinds: readonly Kind[];
}

const OTHER = "other";
const TYPES = [...SURFACE_TYPES.map(({ name }) => name as string), OTHER];

function several(type: string): string {
  if (type === OTHER) return "Others";
  return type === "Torus" ? "Tori" : `${type}s`;
}

export const listed = computed<readonly Whose[]>(() => {
  const state = scene.value;
  if (state.kind !== "ready") return [];
  const { method, rival } = state.scene;
  const matched = reports.value.prediction !== undefined || reports.value.rival !== undefined;
  const titles: Readonly<Record<Side, string>> = {
    truth: matched ? "Ground truth, each with its match" : "Ground truth",
    prediction: `${method ?? ""}${reports.value.prediction ? ", without a match" : ""}`,
    rival: `${rival?.method ?? ""}${reports.value.rival ? ", without a match" : ""}`,
  };
  const whose = { truth: "True", prediction: "Predicted", rival: rival?.method ?? "" };
  return (["truth", "prediction", "rival"] as const).flatMap((side): Whose[] => {
    const primitives = segmentationOf(state.scene, side)?.primitives ?? [];
    const colours = segmentColours(side, reports.value, primitives.length);
    const byType = new Map<string, Listed[]>(TYPES.map((type) => [type, []]));
    primitives.forEach(({ number, type, size }, index) => {
      const ref = { side, index };
      // A match is listed as its true primitive.
      if (standsFor(ref).side !== side) return;
      const kind = type ?? OTHER;
      byType.get(kind)?.push({
        ref,
        number,
        name: `${whose[side]} ${number}: ${kind}`,
        points: size,
        colour: colours[index + 1] ?? UNSEGMENTED,
      });
    });
    const kinds = [...byType].flatMap(([type, found]): Kind[] =>
      found.length > 0 ? [{ type, title: several(type), primitives: found }] : [],
    );
    return kinds.length > 0 ? [{ side, title: titles[side], kinds }] : [];
  });
});
