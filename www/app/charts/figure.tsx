// One chart: drawn, read as a table, or saved.

import type { ComponentChildren, JSX, TargetedPointerEvent } from "preact";
import { useSignal, type Signal } from "@preact/signals";
import { useId, useLayoutEffect, useRef } from "preact/hooks";
import { download } from "../export/download";
import { provenanceOf } from "../export/provenance";
import { isDark } from "../state/settings";
import { follow, frameOf, PRINT, type Frame } from "./plot";

interface Props {
  /** Of the file it is saved as. */
  readonly name: string;
  readonly title: string;
  readonly description: string;
  readonly draw: (frame: Frame) => SVGSVGElement;
  /** Whether the axis of its values is logarithmic, where there is a choice. */
  readonly logarithmic?: Signal<boolean>;
  /** What lies over the drawing, in a box of its size, and what a press in that box begins. */
  readonly over?: ComponentChildren;
  readonly onPress?: (event: TargetedPointerEvent<HTMLElement>) => void;
  /** The figures that are drawn. */
  readonly table: () => ComponentChildren;
}

export function Chart({ name, title, description, draw, logarithmic, over, onPress, table }: Props): JSX.Element {
  const id = useId();
  const asTable = useSignal(false);
  const width = useSignal(0);
  const box = useRef<HTMLDivElement>(null);
  // Colours are read when drawing, so a change of theme must draw anew.
  void isDark();
  const svg = !asTable.value && width.value > 0 ? draw(frameOf(width.value)) : undefined;

  useLayoutEffect(() => {
    const element = box.current;
    if (!element) return;
    const observer = new ResizeObserver(([entry]) => {
      if (entry) width.value = Math.floor(entry.contentRect.width);
    });
    observer.observe(element);
    return () => observer.disconnect();
  }, [asTable.value]);

  useLayoutEffect(() => {
    if (!svg) return;
    svg.setAttribute("role", "img");
    svg.setAttribute("aria-labelledby", `${id}-title`);
    svg.setAttribute("aria-describedby", `${id}-description`);
    box.current?.replaceChildren(svg);
  }, [svg]);

  return (
    <figure class="chart" data-chart={name}>
      <figcaption>
        <h3 id={`${id}-title`}>{title}</h3>
      </figcaption>
      <div class="row">
        <button
          type="button"
          aria-pressed={asTable.value}
          aria-label={`${title} as a table`}
          onClick={() => (asTable.value = !asTable.value)}
        >
          Table
        </button>
        {logarithmic && (
          <button
            type="button"
            aria-pressed={logarithmic.value}
            aria-label={`${title} on a logarithmic axis`}
            onClick={() => (logarithmic.value = !logarithmic.value)}
          >
            Log axis
          </button>
        )}
        <button type="button" aria-label={`Save ${title} as SVG`} onClick={() => void save(name, title, description, draw(PRINT))}>
          Save SVG
        </button>
      </div>
      <p class="hint" id={`${id}-description`}>
        {description}
      </p>
      {asTable.value ? (
        // Focusable, because a wide table scrolls.
        <div key="table" class="chart-table" role="region" aria-labelledby={`${id}-title`} tabIndex={0}>
          {table()}
        </div>
      ) : (
        <div key="drawing" class="chart-box" onPointerDown={onPress}>
          <div class="chart-drawing" ref={box} onClick={follow} />
          {over}
        </div>
      )}
    </figure>
  );
}

const SVG = "http://www.w3.org/2000/svg";

async function save(name: string, title: string, description: string, svg: SVGSVGElement): Promise<void> {
  const ground = document.createElementNS(SVG, "rect");
  ground.setAttribute("width", "100%");
  ground.setAttribute("height", "100%");
  ground.setAttribute("fill", PRINT.surface);
  // Without it a chart is still a chart.
  const provenance = await provenanceOf().catch(() => undefined);
  const about = provenance ? [worded("metadata", JSON.stringify(provenance))] : [];
  svg.prepend(worded("title", title), worded("desc", description), ...about, ground);
  const text = new XMLSerializer().serializeToString(svg);
  download(`fit4cad-${name}.svg`, new Blob([text], { type: "image/svg+xml;charset=utf-8" }));
}

function worded(element: "title" | "desc" | "metadata", text: string): SVGElement {
  const made = document.createElementNS(SVG, element);
  made.textContent = text;
  return made;
}
