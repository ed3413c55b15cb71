// Makes models of STEP files, in a worker of their own. What reads them is fetched at the first.

import * as Comlink from "comlink";
import { signal } from "@preact/signals";
import type { ImportReport } from "../../generated/cad/cad.js";
import { WRITTEN } from "../../shared/roles.mjs";
import { isStep, nameOfPart } from "../../shared/step.mjs";
import { sentence } from "../../shared/text.mjs";
import type { HowImported } from "../../worker/step";
import { stepWorker } from "../engine/step";
import type { BroughtFile } from "../state/inbox";
import type { Gathered } from "./entries";

/** What was gathered, with a line about each part that became a model. */
export interface Opened extends Gathered {
  readonly parts: string[];
}

/** The import under way. */
interface Importing {
  /** The STEP file. */
  readonly path: string;
  readonly stage: string;
  /** How much of the stage is done, of 1. */
  readonly share: number;
  /** Ends it, and those that wait with it. */
  readonly stop: () => void;
}

export const importing = signal<Importing | undefined>(undefined);

/** How a part becomes a model unless something else is asked for. */
const USUAL: HowImported = { options: {} };

/** Replaces every STEP file by the files of a model: points on its faces, and the truth. */
export async function openParts({ files, refused }: Gathered): Promise<Opened> {
  const opened: Opened = { files: files.filter(({ path }) => !isStep(path)), refused: [...refused], parts: [] };
  const stop = new AbortController();
  for (const part of files.filter(({ path }) => isStep(path))) {
    if (stop.signal.aborted) opened.refused.push({ path: part.path, reason: "It was stopped before it was read. Choose it again to have a model of it." });
    else await take(part, opened, stop);
  }
  return opened;
}

async function take(part: BroughtFile, into: Opened, stop: AbortController): Promise<void> {
  try {
    const { files, report } = await importPart(part, USUAL, stop);
    into.files.push(...files);
    into.parts.push(`${part.path}: ${summaryOf(report)}`);
    if (report.doubts.length > 0) into.refused.push({ path: part.path, reason: report.doubts.map(sentence).join(" ") });
  } catch (error) {
    const words = error instanceof Error ? error.message : String(error);
    into.refused.push({ path: part.path, reason: `No model could be made of it: ${words}` });
  }
}

/** The files of a model, and what became of its faces. */
interface Imported {
  readonly files: readonly BroughtFile[];
  readonly report: ImportReport;
}

/** One after the other: each may need much memory. */
let last: Promise<unknown> = Promise.resolve();

/** The files of the model that a STEP file becomes. @throws words for the reader, also where it is stopped. */
export function importPart(part: BroughtFile, how: HowImported, stop = new AbortController()): Promise<Imported> {
  const imported = last.then(() => work(part, how, stop));
  last = imported.catch(() => undefined);
  return imported;
}

async function work(part: BroughtFile, how: HowImported, stop: AbortController): Promise<Imported> {
  stop.signal.throwIfAborted();
  // One that used up the memory must not take it from the next.
  const worker = stepWorker();
  const end = () => worker.end();
  stop.signal.addEventListener("abort", end);
  const show = (stage: string, share: number) => {
    if (!stop.signal.aborted) importing.value = { path: part.path, stage, share, stop: () => stop.abort() };
  };
  try {
    show("reading", 0);
    const { files, paths, report } = await worker.api.read(nameOfPart(part.path), part.data, how, Comlink.proxy(show));
    const step = { ...how, path: part.path, data: part.data, report };
    const of = WRITTEN.map((name) => ({
      ...part,
      path: `${part.path}/${paths[name]}`,
      data: new Blob([files[name]]),
      ...(name === "cloud" && { step }),
    }));
    return { files: of, report };
  } finally {
    stop.signal.removeEventListener("abort", end);
    end();
    importing.value = undefined;
  }
}

export function summaryOf({ faces, bodies }: ImportReport): string {
  const points = faces.reduce((sum, face) => sum + face.points, 0);
  const primitives = new Set(faces.map(({ primitive }) => primitive).filter((primitive) => primitive !== null)).size;
  const met = faces.filter((face) => face.points > 0).length;
  const number = (value: number, one: string, many: string) => `${value.toLocaleString("en")} ${value === 1 ? one : many}`;
  return `${number(points, "point", "points")} on ${number(met, "face", "faces")} of ${number(bodies, "body", "bodies")}, ${number(primitives, "primitive", "primitives")}.`;
}
