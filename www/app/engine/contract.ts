// The engine's types, generated from Rust, and the few names the page gives them.

import type { Measures } from "../../generated/engine/engine.js";

export type {
  Audit,
  Corrected,
  DatasetStatistics,
  DiagnosticInfo as Diagnostic,
  Distribution,
  Finding,
  FitMethod,
  FormAudit,
  Grouping,
  ModelInfo,
  ModelStatistics,
  Override,
  ParameterInfo,
  PartInfo,
  PatchMesh,
  PredictionReport,
  PrimitiveAudit,
  PrimitiveInfo,
  Protocol,
  Report,
  Role,
  SampleOptions,
  Severity,
  Spread,
  SurfaceInfo,
  SurfaceType,
  TruthReport,
} from "../../generated/engine/engine.js";

export type Measure = keyof Measures;
