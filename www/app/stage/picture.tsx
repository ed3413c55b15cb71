// The selected model's points: the canvas, what is said about it, and its controls.

import type { JSX } from "preact";
import { signal } from "@preact/signals";
import { models } from "../state/models";
import { scene } from "../state/scene";
import { hoveredPrimitive, selectedPrimitive, togglePrimitive, type PrimitiveRef } from "../state/selection";
import type { PointView } from "../view/point-view";
import type { Hit, ViewUnavailable } from "../view/types";
import { ViewCanvas } from "../view/view-canvas";
import { currentView } from "./current";
import { layout, wipeAt } from "./display";
import { frame } from "./framing";
import { brushed, takeBrushBack } from "./brush";
import { isLocked } from "./isolation";
import { Legend } from "./legend";
import { link } from "./link";
import { SelectionTools } from "./selection-tools";
import { SideName } from "./side-name";
import { measuring, measureTo, Tape } from "./tape";
import { Tools } from "./tools";
import { primitiveAt, Tooltip, type Pointed } from "./tooltip";

const unavailable = signal<ViewUnavailable | undefined>(undefined);
const pointed = signal<Pointed | undefined>(undefined);

export function Picture(): JSX.Element {
  const current = layout.value;
  return (
    <div class="picture">
      <Tools view={currentView.value} />
      <div class="canvas-box" data-layout={current.kind}>
        <ViewCanvas
          label="Points of the selected model. Drag, or use the arrow keys, to turn; plus and minus enlarge."
          layout={current}
          onLayout={(changed) => {
            if (changed.kind === "wipe") wipeAt.value = changed.at;
          }}
          onReady={attach}
          onUnavailable={(why) => (unavailable.value = why)}
        />
        {!(current.kind === "single" && current.side === 1) && <SideName at="left" />}
        {!(current.kind === "single" && current.side === 0) && <SideName at="right" />}
        <Legend />
        <SelectionTools />
        <BrushedWords />
        <Tape view={currentView.value} />
        {pointed.value && <Tooltip {...pointed.value} />}
        <State />
      </div>
    </div>
  );
}

function attach(created: PointView): () => void {
  const unlink = link(created);
  currentView.value = created;
  const refOf = (hit: Hit | undefined): PrimitiveRef | undefined => {
    const found = hit && primitiveAt(hit);
    return found && { side: found.side, index: found.place };
  };
  created.on("hover", (hit, x, y) => {
    pointed.value = hit && { hit, x, y };
    hoveredPrimitive.value = refOf(hit);
  });
  created.on("click", (hit) => {
    if (measuring.value) {
      if (hit) measureTo(hit);
      return;
    }
    const ref = refOf(hit);
    // The view finds no locked point, but where colours tell outcomes it does not know the primitives.
    if (ref && isLocked(ref)) return;
    if (ref) togglePrimitive(ref);
    else selectedPrimitive.value = undefined;
  });
  created.on("doubleClick", (hit) => {
    const ref = refOf(hit);
    if (ref && !isLocked(ref)) {
      selectedPrimitive.value = ref;
      frame(created, ref);
    } else {
      created.fit();
    }
  });
  return () => {
    unlink();
    currentView.value = undefined;
    pointed.value = undefined;
  };
}

/** What stands out by its distance to the surface, wherever the chart is that chose it. */
function BrushedWords(): JSX.Element | null {
  if (!brushed.value) return null;
  return (
    <p class="tape brushed">
      <span role="status">{brushed.value.words}</span>
      <button type="button" class="link" title="Show all points in their colours again (Esc)" onClick={takeBrushBack}>
        Clear
      </button>
    </p>
  );
}

function State(): JSX.Element | null {
  const state = scene.value;
  if (unavailable.value) {
    return (
      <p class="canvas-state" role="alert">
        There is no picture: {unavailable.value.message} Scores and tables work all the same.
      </p>
    );
  }
  if (state.kind === "failed") {
    return (
      <p class="canvas-state" role="alert">
        The model could not be opened: {state.message}
      </p>
    );
  }
  if (state.kind === "loading" || !currentView.value) return <p class="canvas-state">Opening…</p>;
  if (state.kind === "none") {
    return <p class="canvas-state">{models.value.length > 0 ? "Choose a model to see its points." : "Drop a point cloud anywhere on the page."}</p>;
  }
  return null;
}
