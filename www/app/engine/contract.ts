// The engine's types as the page uses them.

export type Role = "cloud" | "primitives" | "parametric" | "implicit";
export type Protocol = "definition" | "published";
export type Severity = "note" | "warning" | "error";
export type SurfaceType = "Plane" | "Cylinder" | "Cone" | "Sphere" | "Torus";
export type Measure = "DSC" | "PPV" | "TPR" | "TNR" | "NPV" | "ACC" | "MFE" | "dHaus" | "d1";

export interface Override {
  role?: Role;
  model?: string;
  method?: string;
}

export interface GroupedFile {
  path: string;
  role: Role;
  method?: string;
}

export interface Grouping {
  models: { name: string; number?: number; files: GroupedFile[] }[];
  unplaced: { path: string; reason: string }[];
  ignored: number;
}

export interface Diagnostic {
  severity: Severity;
  file: string;
  line?: number;
  column?: number;
  message: string;
  found: string;
  expected: string;
  hint: string;
}

export interface ModelInfo {
  name: string;
  number?: number;
  points: number;
  bounds?: { min: [number, number, number]; max: [number, number, number] };
  hasTruth: boolean;
  methods: string[];
  diagnostics: Diagnostic[];
}

export interface PrimitiveInfo {
  number: number;
  type: string;
  size: number;
  surface?: unknown;
}

export type Measures = Record<Measure, number | null>;

export type PrimitiveReport = Measures & {
  truth: number;
  match: number | null;
  type: string;
};

export interface Report {
  model: string;
  method: string;
  protocol: Protocol;
  points: number;
  truth: number;
  predicted: number;
  mean: Measures;
  type_errors: number;
  primitives: PrimitiveReport[];
  diagnostics: Diagnostic[];
  hidden?: unknown;
}

export interface GenerateOptions {
  seed?: number;
  spacing?: number;
  noise?: number;
  outliers?: number;
  missing?: number;
}

export interface PartInfo {
  name: string;
  title: string;
  description: string;
}
