// Makes a model of one STEP file: its four files, and what became of its faces. And writes surfaces as STEP.

import * as Comlink from "comlink";
import init, { Part, writeStep, type ImportOptions, type ImportReport, type PartFiles, type StepText } from "../generated/cad/cad.js";
import { stayAlive } from "./alive";

const ready = init();

/** How a STEP file becomes a model. */
export interface HowImported {
  readonly options: ImportOptions;
  /** Numbers of the bodies, from 1; all where it is not there. */
  readonly bodies?: readonly number[];
}

export interface ImportedPart {
  readonly files: PartFiles;
  readonly paths: PartFiles;
  readonly report: ImportReport;
}

type Heard = (stage: string, share: number) => void;

/** No more often than an eye can follow: a part may have thousands of faces. */
const PAUSE_MS = 100;

/** Passes on what is new, and of the rest what comes after a pause. */
function now(heard: Heard): Heard {
  let [told, at] = ["", 0];
  return (stage, share) => {
    const time = performance.now();
    if (stage === told && time - at < PAUSE_MS) return;
    [told, at] = [stage, time];
    heard(stage, share);
  };
}

const importer = {
  /** Rejects with words for the reader. `heard` is told what is being done and how much of it is. */
  async read(name: string, data: Blob, { options, bodies }: HowImported, heard: Heard = () => undefined): Promise<ImportedPart> {
    await ready;
    const tell = now(heard);
    const part = Part.read(new Uint8Array(await data.arrayBuffer()), tell);
    try {
      if (bodies) part.keep(Uint32Array.from(bodies));
      const sampled = part.sample(name, options, tell);
      try {
        return { files: sampled.files(), paths: sampled.paths(), report: sampled.report() };
      } finally {
        sampled.free();
      }
    } finally {
      part.free();
    }
  },

  /** The surfaces of a model's files, each type in its colour. */
  async write(name: string, files: PartFiles, colours: Uint8Array): Promise<StepText> {
    await ready;
    return writeStep(name, files, colours);
  },
};

export type StepWorker = typeof importer;

stayAlive();
Comlink.expose(importer);
