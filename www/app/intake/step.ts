// Makes models of STEP files, in a worker of their own. What reads them is fetched at the first.

import type { ImportReport } from "../../generated/cad/cad.js";
import { ROLES } from "../../generated/declared/roles.js";
import { isStep, nameOfPart } from "../../shared/step.mjs";
import { sentence } from "../../shared/text.mjs";
import type { ImportedPart } from "../../worker/step";
import { stepWorker } from "../engine/step";
import type { BroughtFile } from "../state/inbox";
import type { Gathered } from "./entries";

/** What was gathered, with a line about each part that became a model. */
export interface Opened extends Gathered {
  readonly parts: string[];
}

/** Replaces every STEP file by the files of a model: points on its faces, and the truth. */
export async function openParts({ files, refused }: Gathered): Promise<Opened> {
  const opened: Opened = { files: files.filter(({ path }) => !isStep(path)), refused: [...refused], parts: [] };
  for (const part of files.filter(({ path }) => isStep(path))) await take(part, opened);
  return opened;
}

async function take(part: BroughtFile, into: Opened): Promise<void> {
  const name = nameOfPart(part.path);
  // One that used up the memory must not take it from the next.
  const worker = stepWorker();
  try {
    const imported = await worker.api.read(name, part.data);
    for (const file of filesOf(imported)) into.files.push({ ...part, path: `${part.path}/${file.path}`, data: file.data });
    const { report } = imported;
    into.parts.push(`${part.path}: ${summaryOf(report)}`);
    if (report.doubts.length > 0) into.refused.push({ path: part.path, reason: report.doubts.map(sentence).join(" ") });
  } catch (error) {
    const words = error instanceof Error ? error.message : String(error);
    into.refused.push({ path: part.path, reason: `No model could be made of it: ${words}` });
  } finally {
    worker.end();
  }
}

/** In the order of their roles. */
function filesOf({ files, paths }: ImportedPart): { path: string; data: Blob }[] {
  return ROLES.map(({ name }) => ({ path: paths[name], data: new Blob([files[name]]) }));
}

function summaryOf({ faces, bodies }: ImportReport): string {
  const points = faces.reduce((sum, face) => sum + face.points, 0);
  const primitives = new Set(faces.map(({ primitive }) => primitive).filter((primitive) => primitive !== null)).size;
  const number = (value: number, one: string, many: string) => `${value.toLocaleString("en")} ${value === 1 ? one : many}`;
  return `${number(points, "point", "points")} on ${number(faces.length, "face", "faces")} of ${number(bodies, "body", "bodies")}, ${number(primitives, "primitive", "primitives")}.`;
}
