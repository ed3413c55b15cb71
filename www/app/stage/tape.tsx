// A tape measure: distance, angle and radius between points that are picked one after the other.

import type { JSX } from "preact";
import { computed, signal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { scene } from "../state/scene";
import type { PointView } from "../view/point-view";
import type { Hit } from "../view/types";
import { taped, type Place } from "./tape-geometry";

/** Whether a click measures instead of selecting. */
export const measuring = signal(false);

interface Pick {
  readonly hit: Hit;
  /** Of which cloud: a tape does not reach over to another model. */
  readonly cloud: Float32Array;
}

const picks = signal<readonly Pick[]>([]);

/** Three points make a circle and an angle; a fourth begins anew. */
const MOST = 3;

function cloudNow(): Float32Array | undefined {
  const state = scene.value;
  return state.kind === "ready" ? state.scene.positions : undefined;
}

const shown = computed(() => {
  const cloud = cloudNow();
  return measuring.value ? picks.value.filter((pick) => pick.cloud === cloud) : [];
});

const places = computed<readonly Place[]>(() =>
  shown.value.map(({ hit: { index }, cloud }) => [cloud[3 * index] ?? NaN, cloud[3 * index + 1] ?? NaN, cloud[3 * index + 2] ?? NaN]),
);

/** Lays the tape on to a point. */
export function measureTo(hit: Hit): void {
  const cloud = cloudNow();
  if (!cloud) return;
  const before = shown.value.length < MOST ? shown.value : [];
  picks.value = [...before, { hit, cloud }];
}

export function toggleMeasuring(): void {
  measuring.value = !measuring.value;
  picks.value = [];
}

/** Takes back the last point, then the tape; whether there was anything to take back. */
export function takeTapeBack(): boolean {
  if (!measuring.value) return false;
  if (shown.value.length > 0) picks.value = shown.value.slice(0, -1);
  else measuring.value = false;
  return true;
}

export function Tape({ view }: { view: PointView | undefined }): JSX.Element | null {
  if (!measuring.value || !view) return null;
  return (
    <>
      <Line view={view} />
      <p class="tape" role="status">
        {words()}
      </p>
    </>
  );
}

function words(): string {
  const { lengths, angle, radius } = taped(places.value);
  const said = (value: number) => Number(value.toPrecision(5)).toString();
  if (lengths.length === 0) return places.value.length === 0 ? "Click a point to measure from." : "Click a second point.";
  if (angle === undefined || radius === undefined) return `Distance ${lengths.map(said).join()}. A third point gives angle and radius.`;
  const circle = Number.isFinite(radius) ? `radius of the circle through them ${said(radius)}` : "in one line";
  return `Distances ${lengths.map(said).join(" and ")}, angle ${angle.toFixed(2)}°, ${circle}.`;
}

/** The tape over the picture. It follows the camera from frame to frame, as long as there is one. */
function Line({ view }: { view: PointView }): JSX.Element {
  const corners = useCorners(view);
  return (
    <svg class="tape-line" aria-hidden="true">
      <polyline points={corners.map(({ x, y }) => `${x},${y}`).join(" ")} />
      {corners.map(({ x, y }, at) => (
        <circle key={at} cx={x} cy={y} r={4} />
      ))}
    </svg>
  );
}

const corners = signal<readonly { readonly x: number; readonly y: number }[]>([]);

function useCorners(view: PointView) {
  useEffect(() => {
    let request = 0;
    const follow = () => {
      const seen = shown.peek().flatMap(({ hit }, at) => {
        const place = places.peek()[at];
        return (place && view.project(hit.side, [...place])) ?? [];
      });
      const moved = seen.length !== corners.peek().length || seen.some(({ x, y }, at) => x !== corners.peek()[at]?.x || y !== corners.peek()[at]?.y);
      if (moved) corners.value = seen;
      request = requestAnimationFrame(follow);
    };
    follow();
    return () => cancelAnimationFrame(request);
  }, [view]);
  return corners.value;
}
