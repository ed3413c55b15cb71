// The view as a component: a canvas, the wipe's border, and word of what went wrong.

import type { JSX, TargetedKeyboardEvent, TargetedPointerEvent } from "preact";
import { useEffect, useRef, useState } from "preact/hooks";
import { PointView } from "./point-view";
import { type Layout, ViewUnavailable } from "./types";
import "./view.css";

interface Props {
  /** What the canvas shows, for those who cannot see it. */
  readonly label: string;
  readonly layout: Layout;
  /** The border of the wipe was moved. */
  readonly onLayout: (layout: Layout) => void;
  /** The view is there; the result, if any, is called when it goes. */
  readonly onReady: (view: PointView) => (() => void) | void;
  /** There will be no view. */
  readonly onUnavailable: (reason: ViewUnavailable) => void;
}

export function ViewCanvas({ label, layout, onLayout, onReady, onUnavailable }: Props): JSX.Element {
  const canvas = useRef<HTMLCanvasElement>(null);
  const [view, setView] = useState<PointView>();

  useEffect(() => {
    if (!canvas.current) return;
    let made: PointView | undefined;
    let leave: (() => void) | void;
    let gone = false;
    PointView.create(canvas.current).then(
      (created) => {
        made = created;
        if (gone) return created.dispose();
        leave = onReady(created);
        setView(created);
      },
      (error: unknown) => {
        if (gone) return;
        if (error instanceof ViewUnavailable) onUnavailable(error);
        else throw error;
      },
    );
    return () => {
      gone = true;
      leave?.();
      made?.dispose();
    };
    // A view lives as long as its canvas; what the page listens with does not change.
  }, []);

  useEffect(() => view?.setLayout(layout), [view, layout]);

  return (
    <div class="point-view">
      <canvas ref={canvas} tabIndex={0} role="application" aria-label={label} />
      {layout.kind === "wipe" && <WipeBorder at={layout.at} onMove={(at) => onLayout({ kind: "wipe", at })} />}
    </div>
  );
}

/** How far an arrow key moves the border, as a share of the width. */
const STEP = 0.02;

function WipeBorder({ at, onMove }: { at: number; onMove: (at: number) => void }): JSX.Element {
  const move = (to: number) => onMove(Math.min(Math.max(to, 0), 1));

  const drag = (event: TargetedPointerEvent<HTMLDivElement>) => {
    const border = event.currentTarget;
    const around = border.parentElement?.getBoundingClientRect();
    if (around && around.width > 0 && border.hasPointerCapture(event.pointerId)) {
      move((event.clientX - around.left) / around.width);
    }
  };

  const press = (event: TargetedPointerEvent<HTMLDivElement>) => {
    event.currentTarget.setPointerCapture(event.pointerId);
  };

  const key = (event: TargetedKeyboardEvent<HTMLDivElement>) => {
    const steps: Record<string, number> = { ArrowLeft: at - STEP, ArrowRight: at + STEP, Home: 0, End: 1 };
    const to = steps[event.key];
    if (to === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    move(to);
  };

  return (
    <div
      role="slider"
      tabIndex={0}
      aria-label="Border between the two views"
      aria-orientation="horizontal"
      aria-valuemin={0}
      aria-valuemax={100}
      aria-valuenow={Math.round(at * 100)}
      style={{ left: `${at * 100}%` }}
      onPointerDown={press}
      onPointerMove={drag}
      onKeyDown={key}
    />
  );
}
