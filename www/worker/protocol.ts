// What the page asks of an engine worker, and what comes back.
//
// Every call is self-contained: it carries the files it needs, so any worker of the pool can
// answer it and ending a worker loses nothing but the call under way.

import type {
  Audit,
  Corrected,
  DatasetStatistics,
  Distribution,
  FitMethod,
  Grouping,
  ModelInfo,
  ModelStatistics,
  Override,
  ParameterInfo,
  PartInfo,
  PatchMesh,
  PrimitiveInfo,
  Report,
  Role,
  SampleOptions,
} from "../app/engine/contract";

/** A file of a model with the part it plays. The content stays a `Blob`: handing it over copies nothing. */
export interface ModelFile {
  readonly path: string;
  readonly role: Role;
  /** Absent for the ground truth. */
  readonly method?: string;
  readonly data: Blob;
}

/** A model as its files. */
export interface ModelSource {
  /** Equal keys mean equal content: a worker that still holds the model does not read it again. */
  readonly key: string;
  readonly name: string;
  readonly files: readonly ModelFile[];
}

/** Both protocols' reports of one method on one model. */
export interface MethodReports {
  readonly method: string;
  readonly definition: Report;
  readonly published: Report;
}

/** What scoring a model yields. */
export interface ScoredModel {
  readonly info: ModelInfo;
  /** In the engine's order of methods. Empty where there is no truth to score against. */
  readonly reports: readonly MethodReports[];
}

/** One segmentation, as the view draws it and the tables name it. */
export interface SegmentationScene {
  readonly primitives: readonly PrimitiveInfo[];
  /** `offsets[i]..offsets[i + 1]` bounds the points of primitive `i` in `indices`. */
  readonly offsets: Uint32Array<ArrayBuffer>;
  readonly indices: Uint32Array<ArrayBuffer>;
  /** Distance of every listed point to its primitive's surface, in `indices` order; NaN without surface. */
  readonly distances: Float32Array<ArrayBuffer>;
}

/** A model ready to be looked at. */
export interface ModelScene {
  readonly key: string;
  readonly method: string | undefined;
  /** `xyz` per point, relative to `centre`. */
  readonly positions: Float32Array<ArrayBuffer>;
  readonly centre: Float64Array<ArrayBuffer>;
  readonly truth: SegmentationScene | undefined;
  /** The submission of `method`. */
  readonly prediction: SegmentationScene | undefined;
  /** Another submission, to be set beside it. */
  readonly rival: { readonly method: string; readonly segmentation: SegmentationScene } | undefined;
}

/** The text files a segmentation is written as. */
export interface WrittenFiles {
  readonly name: string;
  readonly files: readonly ModelFile[];
}

/** What an audit of a ground truth yields. */
export interface AuditedModel {
  readonly audit: Audit;
  /** Its surface files with wrong vectors replaced; nothing where there is no truth. */
  readonly corrected: Corrected | undefined;
}

/** How a fitter is to be run. */
export interface FitRequest {
  readonly method: FitMethod;
  /** By name; those left out have their defaults. */
  readonly parameters: Readonly<Record<string, number>>;
  readonly seed: number;
}

/** A submission made by a fitter. */
export interface FittedModel {
  /** Its name: that of the method, with a number where the model has one of that name. */
  readonly method: string;
  readonly files: readonly ModelFile[];
  /** How many primitives were found. */
  readonly primitives: number;
  /** Seconds of fitting, without reading. */
  readonly seconds: number;
}

/** Hears the stage of a fit, and how much of the stage is done, 0 to 1. */
export type OnStage = (stage: string, fraction: number) => void;

export interface EngineWorker {
  version(): Promise<string>;
  group(paths: string[], overrides: Record<string, Override>): Promise<Grouping>;
  parts(): Promise<PartInfo[]>;
  /** Makes a sample part: the four files of its truth and those of an imperfect submission, called by `name`. */
  generate(part: string, options: SampleOptions, name: string): Promise<WrittenFiles>;
  score(source: ModelSource): Promise<ScoredModel>;
  open(source: ModelSource, method: string | undefined, rival: string | undefined): Promise<ModelScene>;
  /** Unit normal of every point, without a sign. */
  normals(source: ModelSource): Promise<Float32Array<ArrayBuffer>>;
  /** The patch of a primitive's surface that its points cover; of the truth where no method is given. */
  patch(source: ModelSource, place: number, method: string | undefined): Promise<PatchMesh | undefined>;
  /** How each list of values is spread; NaN is left out, a list of nothing else gives nothing. */
  distributions(lists: readonly Float64Array[]): Promise<(Distribution | undefined)[]>;
  /** Audits the ground truth: its files, and points, parametric and implicit form against each other. */
  audit(source: ModelSource): Promise<AuditedModel>;
  statistics(source: ModelSource): Promise<ModelStatistics>;
  datasetStatistics(models: readonly ModelStatistics[]): Promise<DatasetStatistics>;
  /** The three files of a submission, as the engine writes them. */
  write(source: ModelSource, method: string): Promise<ModelFile[]>;
  /** SHA-256 of each in hexadecimal digits; null on a page that came over an unsafe connection. */
  hash(contents: readonly Blob[]): Promise<(string | null)[]>;
  fitParameters(method: FitMethod): Promise<ParameterInfo[]>;
  /** Fits the bare cloud; `onStage` is to be wrapped by Comlink's `proxy`. */
  fit(source: ModelSource, request: FitRequest, onStage: OnStage): Promise<FittedModel>;
}
