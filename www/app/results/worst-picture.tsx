// A model of a row as it is and as the method found it, drawn of the files on the page: the table keeps no points and no
// answers, so that a picture cannot show anything but what the figures were scored on.

import type { JSX } from "preact";
import { useEffect, useRef, useState } from "preact/hooks";
import type { Entry } from "../../shared/results/scores.mjs";
import type { ModelScene } from "../../worker/protocol";
import type { Report } from "../engine/contract";
import { engine } from "../engine/client";
import { labelling } from "../stage/colouring";
import { scoredRows, type ScoredRow } from "../state/models";
import type { Side } from "../state/selection";
import { bytes } from "../view/palette";
import { flatPicture } from "./flat-picture";
import type { Row } from "./table-data";

/** In pixels of the screen's finest, twice what it takes on the page. */
const SIZE = { width: 440, height: 330, dot: 4 };
const SIDES = [
  ["truth", "truth"],
  ["prediction", "found"],
] as const satisfies readonly (readonly [Side, string])[];

/** What is on the page of a model of the row, if it is there and scored. */
export function onPage({ method }: Row, { model }: Pick<Entry, "model">): ScoredRow | undefined {
  return scoredRows.value.find(({ entry, reports }) => entry.id === model && reports.method === method.answers.called);
}

/** Whether what is on the page is what was scored: every measure to the last digit. */
function isScored({ definition }: Entry, { mean }: Report): boolean {
  return JSON.stringify(sorted(definition)) === JSON.stringify(sorted(mean));
}

function sorted(figures: object): [string, unknown][] {
  return Object.entries(figures).sort(([one], [other]) => (one < other ? -1 : 1));
}

type Drawn = { readonly kind: "asking" } | { readonly kind: "failed"; readonly message: string } | { readonly kind: "drawn"; readonly scene: ModelScene };

export function WorstPicture({ found, entry }: { found: ScoredRow; entry: Entry }): JSX.Element {
  const [drawn, setDrawn] = useState<Drawn>({ kind: "asking" });
  const { source } = found.entry;
  const { method, definition } = found.reports;
  const isSame = isScored(entry, definition);
  useEffect(() => {
    if (!isSame) return;
    const controller = new AbortController();
    const { signal } = controller;
    engine.run((api) => api.open(source, method, undefined), { signal }).then(
      (scene) => !signal.aborted && setDrawn({ kind: "drawn", scene }),
      (error: unknown) => !signal.aborted && setDrawn({ kind: "failed", message: error instanceof Error ? error.message : String(error) }),
    );
    return () => controller.abort();
  }, [source.key, method, isSame]);
  if (!isSame) return <p class="hint">What is on the page as {entry.model} scores otherwise than this row: it is another cloud or another answer, and not drawn here.</p>;
  if (drawn.kind === "failed") return <p role="alert">{entry.model} could not be drawn ({drawn.message}).</p>;
  if (drawn.kind === "asking") return <p class="hint">Drawing {entry.model}…</p>;
  return (
    <div class="results-pictures">
      {SIDES.map(([side, words]) => (
        <figure key={side}>
          <Points label={`Points of ${entry.model} coloured by primitive: ${words}`} side={side} scene={drawn.scene} report={definition} />
          <figcaption>{words}</figcaption>
        </figure>
      ))}
    </div>
  );
}

function Points({ label, side, scene, report }: { label: string; side: Side; scene: ModelScene; report: Report }): JSX.Element {
  const canvas = useRef<HTMLCanvasElement>(null);
  useEffect(() => {
    const { labels, colours } = labelling("segments", side, { scene, reports: { prediction: report }, selected: undefined });
    const pixels = flatPicture(scene.positions, labels, bytes(colours), SIZE);
    canvas.current?.getContext("2d")?.putImageData(new ImageData(pixels, SIZE.width, SIZE.height), 0, 0);
  }, [scene, side, report]);
  return <canvas ref={canvas} width={SIZE.width} height={SIZE.height} role="img" aria-label={label} />;
}
