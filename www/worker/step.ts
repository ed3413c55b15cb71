// Makes a model of one STEP file: its four files, and what became of its faces. And writes surfaces as STEP.

import * as Comlink from "comlink";
import init, { Part, writeStep, type ImportReport, type PartFiles, type StepText } from "../generated/cad/cad.js";
import { stayAlive } from "./alive";

const ready = init();

export interface ImportedPart {
  readonly files: PartFiles;
  readonly paths: PartFiles;
  readonly report: ImportReport;
}

const importer = {
  /** Rejects with words for the reader. */
  async read(name: string, data: Blob): Promise<ImportedPart> {
    await ready;
    const part = Part.read(new Uint8Array(await data.arrayBuffer()));
    try {
      const sampled = part.sample(name, {});
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
