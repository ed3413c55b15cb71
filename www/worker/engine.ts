// The engine in a worker. One call, one answer; the model read last is kept in case it is wanted again.
// It starts as the scorer; the whole engine, with the fitters, is fetched when it is first asked for.

import * as Comlink from "comlink";
import init, { Model, datasetStatistics, distribution, group, parts, version } from "../generated/scorer/scorer.js";
import type { InputFile } from "../generated/engine/engine.js";
import type {
  EngineWorker,
  FittedModel,
  ModelFile,
  ModelSource,
  OnStage,
  SegmentationScene,
  WrittenFiles,
} from "./protocol";

const ready = init();

let fetched: ReturnType<typeof fetchWhole> | undefined;

async function fetchWhole() {
  const whole = await import("../generated/engine/engine.js");
  await whole.default();
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

let held: { key: string; model: Model } | undefined;

async function read(source: ModelSource): Promise<Model> {
  await ready;
  if (held?.key === source.key) return held.model;
  held?.model.free();
  held = undefined;
  const model = Model.read(source.name, await contents(source));
  held = { key: source.key, model };
  return model;
}

function contents(source: ModelSource): Promise<InputFile[]> {
  return Promise.all(
    source.files.map(async ({ path, role, method, data }) => ({
      path,
      role,
      ...(method === undefined ? {} : { method }),
      bytes: new Uint8Array(await data.arrayBuffer()),
    })),
  );
}

function segmentation(model: Model, method?: string): SegmentationScene {
  const { offsets, indices } = model.members(method);
  return {
    primitives: model.primitives(method),
    offsets: offsets as Uint32Array<ArrayBuffer>,
    indices: indices as Uint32Array<ArrayBuffer>,
    distances: model.distances(method) as Float32Array<ArrayBuffer>,
  };
}

function buffersOf(scene: SegmentationScene | undefined): Transferable[] {
  return scene ? [scene.offsets.buffer, scene.indices.buffer, scene.distances.buffer] : [];
}

function written(model: Pick<Model, "write">, name: string, method?: string): ModelFile[] {
  const { cloud, primitives, parametric, implicit } = model.write(method);
  const folder = method === undefined ? "" : `_${method}`;
  const file = (role: ModelFile["role"], text: string): ModelFile => {
    const path = role === "cloud" ? `pointCloud/${name}.txt` : `pointCloud_${role}${folder}/${name}_${role}.txt`;
    return { path, role, ...(method === undefined ? {} : { method }), data: new Blob([text], { type: "text/plain" }) };
  };
  return [
    ...(cloud === undefined ? [] : [file("cloud", cloud)]),
    file("primitives", primitives),
    file("parametric", parametric),
    file("implicit", implicit),
  ];
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

  async parts() {
    await ready;
    return parts();
  },

  async distributions(lists) {
    await ready;
    return lists.map((values) => distribution(values));
  },

  async generate(part, options, name): Promise<WrittenFiles> {
    await ready;
    const model = Model.generate(part, options);
    try {
      const method = model.imperfect(Number(options.seed ?? 1));
      return { name, files: [...written(model, name), ...written(model, name, method)] };
    } finally {
      model.free();
    }
  },

  async score(source) {
    const model = await read(source);
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
    const truth = model.info().hasTruth ? segmentation(model) : undefined;
    const prediction = method === undefined ? undefined : segmentation(model, method);
    const rival = rivalMethod === undefined ? undefined : { method: rivalMethod, segmentation: segmentation(model, rivalMethod) };
    return Comlink.transfer({ key: source.key, method, positions, centre, truth, prediction, rival }, [
      positions.buffer,
      centre.buffer,
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
    return (await read(source)).patch(place, method);
  },

  async audit(source) {
    const whole = await wholeEngine();
    const model = whole.Model.read(source.name, await contents(source));
    try {
      return { audit: model.audit(), corrected: model.info().hasTruth ? model.corrected() : undefined };
    } finally {
      model.free();
    }
  },

  async statistics(source) {
    return (await read(source)).statistics();
  },

  async datasetStatistics(models) {
    await ready;
    return datasetStatistics([...models]);
  },

  async write(source, method) {
    const model = await read(source);
    return written(model, source.name, method);
  },

  async hash(contents) {
    const hashes: (string | null)[] = [];
    // One after the other: together they would all be in memory at once.
    for (const content of contents) hashes.push(await sha256(content));
    return hashes;
  },

  async fitParameters(method) {
    return (await wholeEngine()).fitParameters(method);
  },

  async fit(source, { method, parameters, seed }, onStage): Promise<FittedModel> {
    const whole = await wholeEngine();
    const model = whole.Model.read(source.name, await contents(source));
    try {
      const start = performance.now();
      const name = model.fit(method, { ...parameters }, seed, paced(onStage));
      const seconds = (performance.now() - start) / 1000;
      return { method: name, files: written(model, source.name, name), primitives: model.primitives(name).length, seconds };
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

Comlink.expose(worker);
