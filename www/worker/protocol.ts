// What the page asks of an engine worker, and what comes back.
//
// Every call is self-contained: it carries the files it needs, so any worker of the pool can
// answer it and ending a worker loses nothing but the call under way.

import type {
  Audit,
  By,
  Comparison,
  Condition,
  Correction,
  Counted,
  DatasetStatistics,
  DiagnosticInfo as Diagnostic,
  FieldReport,
  FigureInfo,
  FigureScale,
  FitMethod,
  Grouping,
  Histogram,
  MethodSummary,
  ModelInfo,
  NoiseInfo,
  ModelStatistics,
  Override,
  PatchMesh,
  PrimitiveInfo,
  Report,
  Role,
  SampleOptions,
  Scores,
  SectionInfo,
  Segment,
  StandardErrorsInfo,
} from "../generated/engine/engine.js";
import type { FieldResult } from "../shared/formats/field.mjs";
import type { Reported, comparisonsOf, recognitionOf, spreadsByCondition, spreadsOf, strataOf } from "../shared/formats/field-sums.mjs";
import type { WrittenRole } from "../shared/roles.mjs";

/** A file of a model with the part it plays. The content stays a `Blob`: handing it over copies nothing. */
export interface ModelFile {
  readonly path: string;
  readonly role: Role;
  /** Absent for the ground truth. */
  readonly method?: string;
  /** What its indices of points count from, where the reader says so. */
  readonly first?: number;
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

/** What the field reports of many submissions, summed up. */
export interface FieldSums {
  readonly spreads: ReturnType<typeof spreadsOf>;
  readonly comparisons: ReturnType<typeof comparisonsOf>;
}

/** What takes time beside the figures: the conditions of a model, and its segments with each method's answers. */
export interface Particulars {
  readonly conditions: readonly Condition[];
  readonly segments: Readonly<Record<string, readonly Segment[]>>;
}

/** The same by strata. */
export interface FieldStrata {
  readonly by: By;
  readonly primitives: ReturnType<typeof strataOf>;
  /** Of what is a condition of models. */
  readonly figures: ReturnType<typeof spreadsByCondition>;
  /** Of all segments, and by stratum. */
  readonly segments: ReturnType<typeof recognitionOf>;
  readonly segmentsByStratum: ReturnType<typeof recognitionOf>;
}

/** One segmentation, as the view draws it and the tables name it. */
export interface SegmentationScene {
  readonly primitives: readonly PrimitiveInfo[];
  /** `offsets[i]..offsets[i + 1]` bounds the points of primitive `i` in `indices`. */
  readonly offsets: Uint32Array<ArrayBuffer>;
  readonly indices: Uint32Array<ArrayBuffer>;
  /** Distance of every listed point to its primitive's surface, in `indices` order; NaN without surface. */
  readonly distances: Float32Array<ArrayBuffer>;
  /** The largest of them; 0 where there is none. */
  readonly farthest: number;
  /** The one within which most of them lie. */
  readonly usual: number;
}

/** A model ready to be looked at. */
export interface ModelScene {
  readonly key: string;
  /** Equal for equal coordinates: a model is opened anew for each submission. */
  readonly cloud: string;
  readonly method: string | undefined;
  /** `xyz` per point, relative to `centre`. */
  readonly positions: Float32Array<ArrayBuffer>;
  readonly centre: Float64Array<ArrayBuffer>;
  /** Number of each point in the cloud's file, where that is not its index and one. */
  readonly numbers: Uint32Array<ArrayBuffer> | undefined;
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
  /** What was wrong in its surface files; nothing where there is no truth. */
  readonly corrections: readonly Correction[];
  /** The files that hold a wrong vector, with it replaced. */
  readonly corrected: readonly ModelFile[];
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
  /** The noise it went by. */
  readonly noise: NoiseInfo | undefined;
}

/** Hears how much of a long file is read, 0 to 1. */
export type OnRead = (path: string, share: number) => void;

/** Files of more bytes than this are read piece by piece, and their progress is told. */
export const LONG_FILE_BYTES = 2 ** 23;

/** Hears the stage of a fit, and how much of the stage is done, 0 to 1. */
export type OnStage = (stage: string, fraction: number) => void;

export interface EngineWorker {
  version(): Promise<string>;
  group(paths: string[], overrides: Record<string, Override>): Promise<Grouping>;
  /** The part that the page opens with, as `generate` makes it without options. */
  opening(name: string): Promise<WrittenFiles>;
  /** Makes a sample part: the four files of its truth and those of an imperfect submission, called by `name`. */
  generate(part: string, options: SampleOptions, name: string): Promise<WrittenFiles>;
  /** The primitives of a method, or of the truth, in a form of other programs: a name of the declared exports. */
  export(source: ModelSource, method: string | undefined, form: string): Promise<Blob>;
  /** `onRead` is to be wrapped by Comlink's `proxy`. */
  score(source: ModelSource, onRead?: OnRead): Promise<ScoredModel>;
  open(source: ModelSource, method: string | undefined, rival: string | undefined): Promise<ModelScene>;
  /** Unit normal of every point, without a sign. */
  normals(source: ModelSource): Promise<Float32Array<ArrayBuffer>>;
  /** The patch of a primitive's surface that its points cover; of the truth where no method is given. */
  patch(source: ModelSource, place: number, method: string | undefined): Promise<PatchMesh | undefined>;
  /** What each point is for the true and the predicted primitive at two places: 0 in neither, 1 in both, 2 predicted alone, 3 of the truth alone. */
  outcomes(source: ModelSource, method: string, truth: number | undefined, predicted: number | undefined): Promise<Uint32Array<ArrayBuffer>>;
  /** The paper's figure: per point 0 where nothing is predicted, a true primitive from 1 where it was rightly found, the number after the last where what is predicted is wrong. */
  figure(source: ModelSource, method: string): Promise<Uint32Array<ArrayBuffer>>;
  /** Distances to surfaces, counted on one scale. */
  histogram(source: ModelSource, wanted: readonly Counted[], bins: number, logarithmic: boolean): Promise<Histogram>;
  /** The points, ascending and each once, that the intervals `first` to `last` of that histogram count; a list for each of those asked for. */
  pointsInBins(source: ModelSource, wanted: readonly Counted[], bins: number, logarithmic: boolean, first: number, last: number): Promise<readonly Uint32Array[]>;
  /** How sure the surface of each primitive of a method is by its points. */
  standardErrors(source: ModelSource, method: string): Promise<readonly StandardErrorsInfo[]>;
  /** The cross-section across an axis, at a share of the cloud's extent, of points in a layer as thick as a share of its diagonal; nothing of no points. */
  section(source: ModelSource, method: string | undefined, axis: number, share: number, thickness: number): Promise<SectionInfo | undefined>;
  /** Sums up reports method by method: one call for all of them. */
  summarise(scores: Scores): Promise<MethodSummary[]>;
  /** Compares own figures with others, measure by measure; both row after row. */
  compare(own: Float64Array, theirs: Float64Array): Promise<Comparison[]>;
  /** What the field reports of every submission of a model; nothing where there is no truth. */
  field(source: ModelSource, scale: FigureScale): Promise<readonly FieldReport[]>;
  /** The same of many models, summed up. */
  fieldSums(reports: readonly FieldReport[], figures: readonly Pick<FigureInfo, "key" | "title" | "better">[]): Promise<FieldSums>;
  /** Conditions and segments of a model; nothing of either where there is no truth. */
  particulars(source: ModelSource, normalisation: string): Promise<Particulars>;
  /** Reports with their particulars, by strata. */
  fieldStrata(reports: readonly Reported[], by: By, figures: readonly Pick<FigureInfo, "key" | "title" | "better">[]): Promise<FieldStrata>;
  /** All of that as a file of an extension. */
  fieldText(results: readonly FieldResult[], scale: FigureScale, extension: string): Promise<string>;
  /** Findings as a compiler prints them, a line each. */
  oneLines(diagnostics: readonly Diagnostic[]): Promise<string[]>;
  /** Where the files of a submission lie in the layout of the public test set. */
  submissionPaths(model: string, method: string): Promise<Readonly<Record<WrittenRole, string>>>;
  /** Audits the ground truth: its files, and points, parametric and implicit form against each other. */
  audit(source: ModelSource): Promise<AuditedModel>;
  statistics(source: ModelSource): Promise<ModelStatistics>;
  datasetStatistics(models: readonly ModelStatistics[]): Promise<DatasetStatistics>;
  /** The three files of a submission, as the engine writes them. */
  write(source: ModelSource, method: string): Promise<ModelFile[]>;
  /** The texts of a cloud and of one segmentation of it: that of a method, or the truth. */
  texts(source: ModelSource, method: string | undefined): Promise<Readonly<Record<WrittenRole, string>>>;
  /** SHA-256 of each in hexadecimal digits; null on a page that came over an unsafe connection. */
  hash(contents: readonly Blob[]): Promise<(string | null)[]>;
  /** Whether two files hold the same names and numbers in the same order, whatever blanks stand between. */
  sayTheSame(a: Blob, b: Blob): Promise<boolean>;
  /** Fits the bare cloud; `onStage` is to be wrapped by Comlink's `proxy`. */
  fit(source: ModelSource, request: FitRequest, onStage: OnStage): Promise<FittedModel>;
}
