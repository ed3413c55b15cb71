// The selected model's points: the canvas, what is said about it, and its controls.

import type { JSX } from "preact";
import { useSignal, type Signal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { scene } from "../state/scene";
import { hoveredPrimitive, selectedMethod, selectedPrimitive, togglePrimitive, type PrimitiveRef } from "../state/selection";
import { PointView } from "../view/point-view";
import { ViewUnavailable, type Hit } from "../view/types";
import { arrangement, wipeAt } from "./display";
import { Legend } from "./legend";
import { link } from "./link";
import { Tools } from "./tools";
import { primitiveAt, Tooltip, type Pointed } from "./tooltip";

type Availability = { kind: "starting" } | { kind: "ready"; view: PointView } | { kind: "none"; why: string };

export function Picture(): JSX.Element {
  const canvas = useRef<HTMLCanvasElement>(null);
  const state = useSignal<Availability>({ kind: "starting" });
  const pointed = useSignal<Pointed | undefined>(undefined);

  useEffect(() => {
    if (!canvas.current) return;
    let end: (() => void) | undefined;
    let wanted = true;
    PointView.create(canvas.current).then(
      (view) => {
        if (!wanted) {
          view.dispose();
          return;
        }
        end = attach(view, pointed);
        state.value = { kind: "ready", view };
      },
      (error: unknown) => {
        const why = error instanceof ViewUnavailable ? error.message : String(error);
        state.value = { kind: "none", why };
      },
    );
    return () => {
      wanted = false;
      end?.();
    };
  }, []);

  const current = state.value;
  const view = current.kind === "ready" ? current.view : undefined;
  return (
    <div class="picture">
      <Tools view={view} />
      <div class="canvas-box" data-arrangement={arrangement.value}>
        <canvas
          ref={canvas}
          tabIndex={0}
          role="img"
          aria-label="Points of the selected model, truth and prediction. Drag or use the arrow keys to turn."
        />
        <SideNames />
        {arrangement.value === "wipe" && <WipeSlider />}
        <Legend />
        {pointed.value && <Tooltip {...pointed.value} />}
        <State view={current} />
      </div>
    </div>
  );
}

function attach(view: PointView, pointed: Signal<Pointed | undefined>): () => void {
  const unlink = link(view);
  const refOf = (hit: Hit | undefined): PrimitiveRef | undefined => {
    const found = hit && primitiveAt(hit);
    return found && { side: found.side, index: found.place };
  };
  view.on("hover", (hit, x, y) => {
    pointed.value = hit && { hit, x, y };
    hoveredPrimitive.value = refOf(hit);
  });
  view.on("click", (hit) => {
    const ref = refOf(hit);
    if (ref) togglePrimitive(ref);
    else selectedPrimitive.value = undefined;
  });
  view.on("doubleClick", (hit) => {
    const ref = refOf(hit);
    if (!ref) {
      view.fit();
      return;
    }
    selectedPrimitive.value = ref;
    view.fitLabels(ref.side === "truth" ? 0 : 1, [ref.index + 1]);
  });
  return () => {
    unlink();
    view.dispose();
  };
}

function SideNames(): JSX.Element {
  const chosen = arrangement.value;
  return (
    <>
      {chosen !== "prediction" && <span class="side-name truth">Truth</span>}
      {chosen !== "truth" && <span class="side-name prediction">{selectedMethod.value ?? "No prediction"}</span>}
    </>
  );
}

function WipeSlider(): JSX.Element {
  return (
    <input
      class="wipe"
      type="range"
      min={0}
      max={1}
      step={0.01}
      aria-label="Border between truth and prediction"
      value={wipeAt.value}
      onInput={(event) => (wipeAt.value = event.currentTarget.valueAsNumber)}
    />
  );
}

function State({ view }: { view: Availability }): JSX.Element | null {
  const state = scene.value;
  if (view.kind === "none") {
    return (
      <p class="canvas-state" role="alert">
        There is no picture: {view.why} Scores and tables work all the same.
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
  if (state.kind === "loading" || view.kind === "starting") return <p class="canvas-state">Opening…</p>;
  if (state.kind === "none") return <p class="canvas-state">Choose a model to see its points.</p>;
  return null;
}
