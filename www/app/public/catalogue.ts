// The public models: which there are, and where the public repository keeps their files.

import type { PublishedMethod } from "../../shared/published/methods.mjs";
import { SEGMENTATION } from "../../shared/roles.mjs";
import type { PublicModel, SetName } from "../state/origin";

export interface PublicSet {
  readonly name: SetName;
  readonly title: string;
  /** Models are numbered from 1 to this. */
  readonly count: number;
}

export const SETS: readonly PublicSet[] = [
  { name: "training", title: "Training set", count: 190 },
  { name: "test", title: "Test set", count: 35 },
];

export interface PublicFile {
  /** Where it lies below the base address. */
  readonly address: string;
  /** The path it gets on the page. */
  readonly path: string;
  /** A published result: the model is complete without it. */
  readonly isResult: boolean;
  readonly model: PublicModel;
}

type Role = (typeof SEGMENTATION)[number];

const RESULTS: readonly { readonly method: PublishedMethod; readonly roles: readonly Role[] }[] = [
  { method: "HT", roles: SEGMENTATION },
  // Published as segmentations alone, without surfaces.
  { method: "PG", roles: ["primitives"] },
];

/** The files of one model: its cloud, its ground truth and, if wanted, the published results. */
export function filesOf(set: SetName, number: number, withResults: boolean): PublicFile[] {
  const name = `PC${number}`;
  const model = { set, number };
  const given = (address: string): PublicFile => ({ address, path: address, isResult: false, model });
  if (set === "training") {
    const folder = "dataset/training_set";
    return [`${folder}/${name}.txt`, ...SEGMENTATION.map((role) => `${folder}/${name}_${role}.txt`)].map(given);
  }
  const folder = "dataset/test_set";
  const truth = SEGMENTATION.map((role) => `${folder}/pointCloud_${role}/${name}_${role}.txt`);
  return [`${folder}/pointCloud/${name}.txt`, ...truth].map(given).concat(withResults ? resultsOf(folder, model) : []);
}

/**
 * The repository keeps results beside its evaluation scripts. Here they lie beside their clouds, so
 * that no other PC1 on the page can be taken for theirs.
 */
function resultsOf(folder: string, model: PublicModel): PublicFile[] {
  const name = `PC${model.number}`;
  return RESULTS.flatMap(({ method, roles }) =>
    roles.map((role) => {
      const place = `pointCloud_${role}_${method}/${name}_${role}.txt`;
      return { address: `MATLAB/${place}`, path: `${folder}/${place}`, isResult: true, model };
    }),
  );
}

export type Numbers =
  | { readonly kind: "numbers"; readonly numbers: readonly number[] }
  | { readonly kind: "wrong"; readonly reason: string };

/** Reads `1-5, 9`: the numbers in order, each once. */
export function readNumbers(text: string, { count }: PublicSet): Numbers {
  const chosen = new Set<number>();
  const parts = text.replace(/\s*[-–]\s*/g, "-").split(/[,;\s]+/);
  for (const part of parts.filter((part) => part !== "")) {
    const match = /^(?:PC)?(\d{1,6})(?:-(?:PC)?(\d{1,6}))?$/i.exec(part);
    if (!match) return wrong(`“${part}” is no number or range. Write, for example, 1-5, 9.`);
    const first = Number(match[1]);
    const last = Number(match[2] ?? match[1]);
    if (first > last) return wrong(`The range ${part} runs backwards. Write ${last}-${first}.`);
    if (first < 1 || last > count) return wrong(`${part} is outside this set, which runs from 1 to ${count}.`);
    for (let number = first; number <= last; number++) chosen.add(number);
  }
  if (chosen.size === 0) return wrong(`Write the numbers of the models, from 1 to ${count}.`);
  return { kind: "numbers", numbers: [...chosen].sort((a, b) => a - b) };
}

function wrong(reason: string): Numbers {
  return { kind: "wrong", reason };
}
