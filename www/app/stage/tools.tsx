// The view's controls.

import type { JSX } from "preact";
import type { Signal } from "@preact/signals";
import type { PointView } from "../view/point-view";
import { LookFrom } from "../view/look-from";
import { alone, toggleAlone } from "../state/extent";
import { scene } from "../state/scene";
import { goToPanel } from "../state/panels";
import { Icon } from "../ui/icon";
import { Lazy } from "../ui/lazy";
import { Popover } from "../ui/popover";
import { COLOUR_MODES, type ColourMode } from "./colouring";
import { picturing } from "./current";
import { CutAxis, CutPlace } from "./cut-fields";
import {
  WHOLE_BOX,
  arrangement,
  ARRANGEMENTS,
  clipBox,
  colourMode,
  cutAcross,
  cutBelow,
  eyeDome,
  pointSize,
  projection,
  surfaces,
  unsegmentedShown,
  type Arrangement,
} from "./display";
import { measuring, toggleMeasuring } from "./tape";

const loadClipBox = () => import("./clip-box");

export function Tools({ view }: { view: PointView | undefined }): JSX.Element {
  return (
    <div class="picture-tools">
      <label>
        Colour
        <select value={colourMode.value} onChange={(event) => (colourMode.value = event.currentTarget.value as ColourMode)}>
          {COLOUR_MODES.map(({ id, title }) => (
            <option key={id} value={id}>
              {title}
            </option>
          ))}
        </select>
      </label>
      <label>
        <span class="visually-hidden">Arrangement</span>
        <select
          value={arrangement.value}
          onChange={(event) => (arrangement.value = event.currentTarget.value as Arrangement)}
        >
          {ARRANGEMENTS.map(({ id, title }) => (
            <option key={id} value={id}>
              {title}
            </option>
          ))}
        </select>
      </label>
      <LookFrom view={view} />
      <button type="button" disabled={!view} title="Bring the whole model into the view (0, while the view has the focus)" onClick={() => view?.fit()}>
        Frame all
      </button>
      <button type="button" disabled={!view || scene.value.kind !== "ready"} title="Save a picture (C)" onClick={() => (picturing.value = true)}>
        Save picture
      </button>
      <button
        type="button"
        class="icon alone"
        aria-pressed={alone.value}
        aria-label="Picture alone"
        title={alone.value ? "Show the tables again (V, Esc)" : "Show the picture alone (V)"}
        onClick={toggleAlone}
      >
        <Icon name={alone.value ? "shrink" : "spread"} />
      </button>
      <button type="button" aria-pressed={measuring.value} title="Measure distance, angle and radius between points (E)" onClick={toggleMeasuring}>
        Measure
      </button>
      <Popover label="Display">
        <div class="display-options">
          <label class="size">
            Size
            <input
              type="range"
              min={0.4}
              max={4}
              step={0.1}
              value={pointSize.value}
              onInput={(event) => (pointSize.value = event.currentTarget.valueAsNumber)}
            />
          </label>
          <Toggle on={unsegmentedShown} yes="on" no="off" label="Unsegmented" />
          <Toggle on={eyeDome} yes="on" no="off" label="Depth shading" />
          <Toggle on={surfaces} yes="on" no="off" label="Fitted surface" />
          <Toggle on={projection} yes="orthographic" no="perspective" label="Orthographic" />
          <label>
            Cut open across
            <CutAxis />
          </label>
          {cutAcross.value !== "none" && (
            <>
              <label class="size">
                Place of the cut
                <CutPlace />
              </label>
              <label class="check">
                <input type="checkbox" checked={cutBelow.value} onChange={(event) => (cutBelow.value = event.currentTarget.checked)} />
                Show what lies above it
              </label>
              <button type="button" onClick={() => goToPanel("section")}>
                Show the cross-section
              </button>
            </>
          )}
          <label class="check">
            <input type="checkbox" checked={clipBox.value !== undefined} onChange={(event) => (clipBox.value = event.currentTarget.checked ? WHOLE_BOX : undefined)} />
            Clipping box
          </label>
          {clipBox.value && <Lazy load={loadClipBox} title="Clipping box" />}
        </div>
      </Popover>
    </div>
  );
}

function Toggle<T extends string>({ on, yes, no, label }: { on: Signal<T>; yes: T; no: T; label: string }): JSX.Element {
  return (
    <label class="check">
      <input
        type="checkbox"
        checked={on.value === yes}
        onChange={(event) => (on.value = event.currentTarget.checked ? yes : no)}
      />
      {label}
    </label>
  );
}
