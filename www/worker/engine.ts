// The engine in a worker. One call, one answer; the model read last is kept in case it is wanted again.
// It starts as the scorer; the whole engine, with the fitters, is fetched when it is first asked for.

import * as Comlink from "comlink";
import init, { Model, compare, group, oneLines, pathOf, summarise, version } from "../generated/scorer/scorer.js";
import type { Model as WholeModel } from "../generated/engine/engine.js";
import { comparisonsOf, recognitionOf, spreadsByCondition, spreadsOf, strataOf } from "../shared/formats/field-sums.mjs";
import { EXPORT_COLOURS } from "../shared/palette.mjs";
import { stayAlive } from "./alive";
import { modelOf } from "./input";
import { cloudKey } from "./same-cloud";
import { sameWords } from "./same-words";
import { usualDistance } from "./usual";
import type {
  EngineWorker,
  FittedModel,
  ModelFile,
  ModelSource,
  OnRead,
  OnStage,
  SegmentationScene,
  WrittenFiles,
} from "./protocol";

const ready = init();

let fetched: ReturnType<typeof fetchWhole> | undefined;

async function fetchWhole() {
  const whole = await import("../generated/engine/engine.js");
  // The scorer goes on telling what does not depend on a model.
  await Promise.all([whole.default(), ready]);
  return whole;
}

/** The whole engine. A fetch that failed, as it does offline, is tried again the next time. */
function wholeEngine(): ReturnType<typeof fetchWhole> {
  fetched ??= fetchWhole().catch((error: unknown) => {
    fetched = undefined;
    throw error;
  });
  return fetched;
}

const PACE_MS = 80;

let held: { key: string; model: Model; whole: WholeModel | undefined } | undefined;

async function read(source: ModelSource, onRead?: OnRead): Promise<Model> {
  await ready;
  if (held?.key === source.key) return held.model;
  letGo();
  const { model, whole } = await wholly(source, onRead);
  // Another may have been read while the whole engine was fetched.
  letGo();
  held = { key: source.key, model, whole };
  return model;
}

/** Read by the whole engine, for what the scorer cannot do; from then on it is the one held. */
async function readWholly(source: ModelSource): Promise<WholeModel> {
  const engine = await wholeEngine();
  if (held?.key === source.key && held.whole) return held.whole;
  letGo();
  const whole = modelOf(engine.Model, source.name, source.files);
  held = { key: source.key, model: whole as unknown as Model, whole };
  return whole;
}

function letGo(): void {
  held?.model.free();
  held = undefined;
}

/** Read by the whole engine where the scorer leaves something to it. */
async function wholly({ name, files }: ModelSource, onRead?: OnRead): Promise<{ model: Model; whole: WholeModel | undefined }> {
  const model = modelOf(Model, name, files, onRead);
  if (!model.wantsWhole()) return { model, whole: undefined };
  model.free();
  const whole = modelOf((await wholeEngine()).Model, name, files, onRead);
  return { model: whole as unknown as Model, whole };
}

function segmentation(model: Model, method?: string): SegmentationScene {
  const { offsets, indices } = model.members(method);
  const distances = model.distances(method) as Float32Array<ArrayBuffer>;
  return {
    primitives: model.primitives(method),
    offsets: offsets as Uint32Array<ArrayBuffer>,
    indices: indices as Uint32Array<ArrayBuffer>,
    distances,
    farthest: model.farthest(method),
    usual: usualDistance(distances),
  };
}

function buffersOf(scene: SegmentationScene | undefined): Transferable[] {
  return scene ? [scene.offsets.buffer, scene.indices.buffer, scene.distances.buffer] : [];
}

function written(model: Pick<Model, "write">, name: string, method?: string): ModelFile[] {
  const { cloud, primitives, parametric, implicit } = model.write(method);
  const file = (role: ModelFile["role"], text: string): ModelFile => ({
    path: pathOf("test-set", name, role, method),
    role,
    ...(method === undefined ? {} : { method }),
    data: new Blob([text], { type: "text/plain" }),
  });
  return [
    ...(cloud === undefined ? [] : [file("cloud", cloud)]),
    file("primitives", primitives),
    file("parametric", parametric),
    file("implicit", implicit),
  ];
}

/** The files of a part that was made, with those of a submission that is wrong on purpose. */
function sampled(model: Pick<Model, "imperfect" | "write" | "free">, name: string, seed: number | bigint = 1): WrittenFiles {
  try {
    const method = model.imperfect(Number(seed));
    return { name, files: [...written(model, name), ...written(model, name, method)] };
  } finally {
    model.free();
  }
}

/** Passes on each new stage, and what is done of it a few times a second: every message costs the page time. */
function paced(onStage: OnStage): OnStage {
  let last = { stage: "", at: -Infinity };
  return (stage, fraction) => {
    const now = performance.now();
    if (stage === last.stage && now - last.at < PACE_MS) return;
    last = { stage, at: now };
    onStage(stage, fraction);
  };
}

const worker: EngineWorker = {
  async version() {
    await ready;
    return version();
  },

  async group(paths, overrides) {
    await ready;
    return group(paths, overrides);
  },

  async outcomes(source, method, truth, predicted) {
    const labels = (await read(source)).outcomes(method, truth, predicted) as Uint32Array<ArrayBuffer>;
    return Comlink.transfer(labels, [labels.buffer]);
  },

  async figure(source, method) {
    const labels = (await read(source)).figure(method) as Uint32Array<ArrayBuffer>;
    return Comlink.transfer(labels, [labels.buffer]);
  },

  async histogram(source, wanted, bins, logarithmic) {
    return (await read(source)).histogram([...wanted], bins, logarithmic);
  },

  async pointsInBins(source, wanted, bins, logarithmic, first, last) {
    return (await read(source)).pointsInBins([...wanted], bins, logarithmic, first, last);
  },

  async section(source, method, axis, share, thickness) {
    return (await readWholly(source)).section(axis, share, thickness, method);
  },

  async standardErrors(source, method) {
    return (await readWholly(source)).standardErrors(method);
  },

  async summarise(scores) {
    await ready;
    return summarise(scores);
  },

  async compare(own, theirs) {
    await ready;
    return compare(own, theirs);
  },

  async field(source, scale) {
    const whole = await wholeEngine();
    const model = modelOf(whole.Model, source.name, source.files);
    try {
      const { hasTruth, methods } = model.info();
      return hasTruth ? methods.map((method) => model.field(method, scale)) : [];
    } finally {
      model.free();
    }
  },

  async fieldSums(reports, figures) {
    const whole = await wholeEngine();
    return {
      spreads: spreadsOf(whole, reports, figures),
      comparisons: comparisonsOf(whole, reports, figures),
    };
  },

  async particulars(source, normalisation) {
    const whole = await wholeEngine();
    const model = modelOf(whole.Model, source.name, source.files);
    try {
      const { hasTruth, methods } = model.info();
      if (!hasTruth) return { conditions: [], segments: {} };
      const segments = methods.map((method) => [method, model.segments(method, normalisation)] as const);
      return { conditions: model.conditions(), segments: Object.fromEntries(segments) };
    } finally {
      model.free();
    }
  },

  async fieldStrata(reports, by, figures) {
    const whole = await wholeEngine();
    return {
      by,
      primitives: strataOf(whole, reports, by),
      figures: spreadsByCondition(whole, reports, by, figures),
      segments: recognitionOf(whole, reports),
      segmentsByStratum: recognitionOf(whole, reports, by),
    };
  },

  async fieldText(results, scale, extension) {
    const [whole, { fieldText }] = await Promise.all([wholeEngine(), import("../shared/formats/field.mjs")]);
    return fieldText(whole, results, scale, extension);
  },

  async oneLines(diagnostics) {
    await ready;
    return oneLines([...diagnostics]);
  },

  async submissionPaths(model, method) {
    await ready;
    const path = (role: ModelFile["role"]) => pathOf("test-set", model, role, method);
    return { cloud: path("cloud"), primitives: path("primitives"), parametric: path("parametric"), implicit: path("implicit") };
  },

  async opening(name) {
    await ready;
    return sampled(Model.opening(), name);
  },

  async generate(part, options, name) {
    return sampled((await wholeEngine()).Model.generate(part, options), name, options.seed);
  },

  async export(source, method, form) {
    const whole = await wholeEngine();
    const model = modelOf(whole.Model, source.name, source.files);
    try {
      return new Blob([model.export(form, method, EXPORT_COLOURS) as Uint8Array<ArrayBuffer>]);
    } finally {
      model.free();
    }
  },

  async score(source, onRead) {
    const model = await read(source, onRead);
    const info = model.info();
    const reports = info.hasTruth
      ? info.methods.map((method) => ({
          method,
          definition: model.score(method, "definition"),
          published: model.score(method, "published"),
        }))
      : [];
    return { info, reports };
  },

  async open(source, method, rivalMethod) {
    const model = await read(source);
    const positions = model.positions() as Float32Array<ArrayBuffer>;
    const centre = model.centre() as Float64Array<ArrayBuffer>;
    const numbers = model.numbers() as Uint32Array<ArrayBuffer> | undefined;
    const truth = model.info().hasTruth ? segmentation(model) : undefined;
    const prediction = method === undefined ? undefined : segmentation(model, method);
    const rival = rivalMethod === undefined ? undefined : { method: rivalMethod, segmentation: segmentation(model, rivalMethod) };
    return Comlink.transfer({ key: source.key, cloud: cloudKey(positions), method, positions, centre, numbers, truth, prediction, rival }, [
      positions.buffer,
      centre.buffer,
      ...(numbers ? [numbers.buffer] : []),
      ...buffersOf(truth),
      ...buffersOf(prediction),
      ...buffersOf(rival?.segmentation),
    ]);
  },

  async normals(source) {
    const normals = (await read(source)).normals() as Float32Array<ArrayBuffer>;
    return Comlink.transfer(normals, [normals.buffer]);
  },

  async patch(source, place, method) {
    return (await readWholly(source)).patch(place, method);
  },

  async audit(source) {
    const whole = await wholeEngine();
    const model = modelOf(whole.Model, source.name, source.files);
    try {
      const audit = model.audit();
      if (!model.info().hasTruth) return { audit, corrections: [], corrected: [] };
      const { corrections, ...texts } = model.corrected();
      const corrected = (["parametric", "implicit"] as const).flatMap((role): ModelFile[] => {
        const text = texts[role];
        const path = pathOf("beside", source.name, role);
        return text === undefined ? [] : [{ path, role, data: new Blob([text], { type: "text/plain" }) }];
      });
      return { audit, corrections, corrected };
    } finally {
      model.free();
    }
  },

  async statistics(source) {
    return (await readWholly(source)).statistics();
  },

  async datasetStatistics(models) {
    return (await wholeEngine()).datasetStatistics([...models]);
  },

  async write(source, method) {
    const model = await read(source);
    return written(model, source.name, method);
  },

  async texts(source, method) {
    const model = await read(source);
    return { ...model.write(method), cloud: model.cloud() };
  },

  async hash(contents) {
    const hashes: (string | null)[] = [];
    // One after the other: together they would all be in memory at once.
    for (const content of contents) hashes.push(await sha256(content));
    return hashes;
  },

  async sayTheSame(a, b) {
    return sameWords(await a.text(), await b.text());
  },

  async fit(source, { method, parameters, seed }, onStage): Promise<FittedModel> {
    const whole = await wholeEngine();
    const model = modelOf(whole.Model, source.name, source.files);
    try {
      const start = performance.now();
      const name = model.fit(method, { ...parameters }, seed, paced(onStage));
      const seconds = (performance.now() - start) / 1000;
      return { method: name, files: written(model, source.name, name), primitives: model.primitives(name).length, seconds, noise: model.noise(name) };
    } finally {
      model.free();
    }
  },
};

async function sha256(content: Blob): Promise<string | null> {
  // Absent where the page is not a secure context, whatever the types say.
  const subtle = crypto.subtle as SubtleCrypto | undefined;
  if (!subtle) return null;
  const digest = await subtle.digest("SHA-256", await content.arrayBuffer());
  return Array.from(new Uint8Array(digest), (byte) => byte.toString(16).padStart(2, "0")).join("");
}

stayAlive();
Comlink.expose(worker);
