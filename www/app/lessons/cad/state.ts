// What the lesson on parts from CAD holds: how a drawing is sampled, the points that come of it, what a fitter
// finds on them, and what of that a CAD system would read.

import { batch, computed, signal } from "@preact/signals";
import type { ImportReport } from "../../../generated/cad/cad.js";
import type { LessonModel, LessonSegmentation } from "../../../worker/lessons";
import type { StepWorker } from "../../../worker/step";
import { partAsStep } from "../../../shared/step-part.mjs";
import { TYPE_COLOURS } from "../../../shared/step.mjs";
import { latest } from "../../engine/latest";
import type { LiveWorker } from "../../engine/live-worker";
import { stepWorker } from "../../engine/step";
import type { FitMethod } from "../../engine/contract";
import type { Session } from "../session";

export const NAME = "plate";
export type Spread = "even" | "random" | "scan";

/** How the drawing becomes points. */
export interface How {
  readonly points: number;
  readonly spread: Spread;
  /** Viewpoints of a scan. */
  readonly views: number;
  /** Standard deviation in each coordinate, over the diagonal. */
  readonly noise: number;
}

export const how = signal<How>({ points: 1000, spread: "even", views: 1, noise: 0 });
export const part = signal<LessonModel | undefined>(undefined);
export const report = signal<ImportReport | undefined>(undefined);
export const method = signal<FitMethod>("ht");
export const segmentation = signal<LessonSegmentation | undefined>(undefined);
/** What was found, as STEP, and what reading that gives. */
export const written = signal<{ readonly text: string; readonly leftOut: number; readonly read: ImportReport } | undefined>(undefined);
export const busy = signal(false);

export const faces = computed(() => report.value?.faces ?? []);
/** How many faces have points. */
export const seen = computed(() => faces.value.filter(({ points }) => points > 0).length);
export const total = computed(() => faces.value.reduce((sum, { points }) => sum + points, 0));
export const dsc = computed(() => segmentation.value?.report.mean.DSC ?? undefined);

let cad: LiveWorker<StepWorker> | undefined;

/** Reads the drawing; nothing of an earlier visit is left. */
export async function open(session: Session): Promise<void> {
  close();
  cad = stepWorker();
  await make(session, how.value);
}

/** Ends what reads the drawing. */
export function close(): void {
  cad?.end();
  cad = undefined;
  batch(() => {
    part.value = undefined;
    report.value = undefined;
    forget();
  });
}

function forget(): void {
  segmentation.value = undefined;
  written.value = undefined;
}

function reader() {
  if (!cad) throw new Error("The lesson has not begun.");
  return cad.api;
}

async function make({ engine }: Session, { noise, points, spread, views }: How): Promise<void> {
  const options = { points, spread, ...(spread === "scan" && { views }) };
  const imported = await reader().read(NAME, new Blob([partAsStep()]), { options });
  const model = await engine.texts(NAME, { ...imported.files }, noise);
  batch(() => {
    part.value = model;
    report.value = imported.report;
    forget();
  });
}

/** Samples the drawing as it is asked for now, as often as the engine can follow. */
export function sampler(session: Session): () => Promise<void> {
  const ask = latest((asked: How) => make(session, asked));
  return () => ask(how.value);
}

export async function fit({ engine }: Session): Promise<void> {
  busy.value = true;
  try {
    const found = await engine.segment(method.value);
    batch(() => {
      segmentation.value = found;
      written.value = undefined;
    });
  } finally {
    busy.value = false;
  }
}

/** Writes what was found as STEP, and reads that as any other drawing. */
export async function goBack({ engine }: Session): Promise<void> {
  busy.value = true;
  try {
    const step = await reader().write(NAME, await engine.found(), TYPE_COLOURS);
    const { report: read } = await reader().read(NAME, new Blob([step.text]), { options: { separate: true } });
    written.value = { text: step.text, leftOut: step.leftOut, read };
  } finally {
    busy.value = false;
  }
}
