// The sides of the clipping box: along x, y and z, where it begins and where it ends.

import type { JSX } from "preact";
import { computed } from "@preact/signals";
import { scene } from "../state/scene";
import { clipBox } from "./display";
import "./clip-box.css";

const AXES = ["x", "y", "z"] as const;
const STEP = 0.005;

/** Least coordinate of the cloud along each axis, and how far it reaches. */
const extent = computed(() => {
  const state = scene.value;
  if (state.kind !== "ready") return undefined;
  const { positions, centre } = state.scene;
  return AXES.map((_, axis) => {
    let [low, high] = [Infinity, -Infinity];
    for (let at = axis; at < positions.length; at += 3) {
      const value = positions[at] ?? NaN;
      low = Math.min(low, value);
      high = Math.max(high, value);
    }
    return { low: low + (centre[axis] ?? 0), length: high - low };
  });
});

export default function ClipBoxSides(): JSX.Element | null {
  const box = clipBox.value;
  if (!box) return null;
  const words = (axis: number, share: number) => {
    const along = extent.value?.[axis];
    return along ? Number((along.low + share * along.length).toPrecision(4)).toString() : `${Math.round(share * 100)} %`;
  };
  const set = (end: "low" | "high", axis: number, share: number): number => {
    const changed = (sides: readonly number[]) => [0, 1, 2].map((each) => (each === axis ? share : (sides[each] ?? 0))) as [number, number, number];
    clipBox.value = { ...box, [end]: changed(box[end]) };
    return share;
  };
  return (
    <div class="clip-box" role="group" aria-label="Sides of the clipping box">
      {AXES.map((axis, at) => {
        const [low, high] = [box.low[at] ?? 0, box.high[at] ?? 1];
        return (
          <div key={axis} class="clip-axis">
            <span>{axis}</span>
            <Side label={`${axis} from`} value={low} words={words(at, low)} onSlide={(to) => set("low", at, Math.min(to, high))} />
            <Side label={`${axis} to`} value={high} words={words(at, high)} onSlide={(to) => set("high", at, Math.max(to, low))} />
            <output>
              {words(at, low)} to {words(at, high)}
            </output>
          </div>
        );
      })}
    </div>
  );
}

interface SideProps {
  readonly label: string;
  readonly value: number;
  readonly words: string;
  /** Gives where it stays: one side does not pass the other. */
  readonly onSlide: (to: number) => number;
}

function Side({ label, value, words, onSlide }: SideProps): JSX.Element {
  return (
    <input
      type="range"
      min={0}
      max={1}
      step={STEP}
      value={value}
      aria-label={label}
      aria-valuetext={words}
      onInput={({ currentTarget }) => {
        currentTarget.value = String(onSlide(currentTarget.valueAsNumber));
      }}
    />
  );
}
