// The engine's types, generated from Rust, and the few names the page gives them.

import type { Measures } from "../../generated/engine/engine.js";

export type {
  DiagnosticInfo as Diagnostic,
  Distribution,
  FitMethod,
  Grouping,
  ModelInfo,
  Override,
  ParameterInfo,
  PartInfo,
  PatchMesh,
  PredictionReport,
  PrimitiveInfo,
  Protocol,
  Report,
  Role,
  SampleOptions,
  Severity,
  SurfaceInfo,
  SurfaceType,
  TruthReport,
} from "../../generated/engine/engine.js";

export type Measure = keyof Measures;
