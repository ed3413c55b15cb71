// The section as a drawing: points in the colours of their primitives, and through them the curves of the surfaces.

import type { JSX } from "preact";
import { drawingOrder, isMeantBy, labelsOf, segmentationOf, segmentColours } from "../stage/colouring";
import { reports } from "../stage/reports";
import { wordsFor } from "../stage/tooltip";
import { hoveredPrimitive, selectedPrimitive, togglePrimitive, type PrimitiveRef } from "../state/selection";
import { UNSEGMENTED } from "../view/palette";
import type { Section } from "./state";

/** More points are drawn in part: each so-manieth of them. */
const MOST_POINTS = 20_000;
/** Room around the cloud, as a share of its larger side. */
const ROOM = 0.04;

/** What the axes to the right and upwards are called, by the axis the section is across. */
const AXES = [
  ["y", "z"],
  ["x", "z"],
  ["x", "y"],
] as const;

export interface Curve {
  readonly ref: PrimitiveRef;
  readonly name: string;
  readonly meeting: string;
  readonly colour: string;
  /** As an SVG path has it, upwards negative. */
  readonly path: string;
}

export function curvesOf({ scene, side, info }: Section): Curve[] {
  const count = segmentationOf(scene, side)?.primitives.length ?? 0;
  const colours = segmentColours(side, reports.value, count);
  return info.curves.map(({ place, meeting, positions, chains }) => {
    const pieces = Array.from({ length: chains.length - 1 }, (_, chain) => {
      const places = positions.subarray(2 * (chains[chain] ?? 0), 2 * (chains[chain + 1] ?? 0));
      return `M${Array.from({ length: places.length / 2 }, (_, at) => `${places[2 * at]} ${-(places[2 * at + 1] ?? 0)}`).join("L")}`;
    });
    return {
      ref: { side, index: place },
      name: wordsFor(scene, side, place) ?? "",
      meeting,
      colour: colours[place + 1] ?? UNSEGMENTED,
      path: pieces.join(""),
    };
  });
}

/** The points of each colour as a path of dots. */
function dotsOf({ scene, side, info }: Section): { colour: string; path: string }[] {
  const segmentation = segmentationOf(scene, side);
  if (!segmentation) return [];
  const labels = labelsOf(segmentation, scene.positions.length / 3, drawingOrder(side, reports.value, segmentation));
  const colours = segmentColours(side, reports.value, segmentation.primitives.length);
  const stride = Math.ceil(info.points.length / MOST_POINTS);
  const paths = new Map<string, string[]>();
  info.points.forEach((index, at) => {
    if (at % stride !== 0) return;
    const colour = colours[labels[index] ?? 0] ?? UNSEGMENTED;
    const dot = `M${info.positions[2 * at]} ${-(info.positions[2 * at + 1] ?? 0)}h0`;
    const path = paths.get(colour);
    if (path) path.push(dot);
    else paths.set(colour, [dot]);
  });
  return [...paths].map(([colour, dots]) => ({ colour, path: dots.join("") }));
}

export function Drawing({ section, curves, label }: { section: Section; curves: readonly Curve[]; label: string }): JSX.Element {
  const [width, height] = section.info.size;
  const room = ROOM * Math.max(width, height) || 1;
  const box = [-width / 2 - room, -height / 2 - room, width + 2 * room, height + 2 * room];
  const [right, up] = AXES[section.cut.axis] ?? AXES[2];
  return (
    <div class="section-drawing">
      <svg viewBox={box.join(" ")} role="img" aria-label={label}>
        <rect class="extent" x={-width / 2} y={-height / 2} width={width} height={height} />
        {dotsOf(section).map(({ colour, path }) => (
          <path key={colour} class="dots" d={path} stroke={colour} />
        ))}
        {curves.map(({ ref, name, meeting, colour, path }) => (
          <path
            key={ref.index}
            class="curve"
            d={path}
            stroke={colour}
            data-selected={isMeantBy(reports.value, selectedPrimitive.value, ref) || undefined}
            data-hovered={isMeantBy(reports.value, hoveredPrimitive.value, ref) || undefined}
            onClick={() => togglePrimitive(ref)}
            onMouseEnter={() => (hoveredPrimitive.value = ref)}
            onMouseLeave={() => (hoveredPrimitive.value = undefined)}
          >
            <title>{`${name}, ${meeting}`}</title>
          </path>
        ))}
      </svg>
      <span class="axis right" aria-hidden="true">
        {right} →
      </span>
      <span class="axis up" aria-hidden="true">
        {up} ↑
      </span>
    </div>
  );
}
