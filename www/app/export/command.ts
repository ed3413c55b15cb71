// The command line that repeats what is on screen.

import { SAMPLE_OPTIONS } from "../../generated/declared/sample-options.js";
import type { ImportOptions } from "../../generated/cad/cad.js";
import type { FitRequest } from "../../worker/protocol";
import type { Override, Protocol, SampleOptions } from "../engine/contract";

/** A sample on the page, with the imperfect submission it comes with. */
export interface SampleOnScreen {
  /** What it is called on the page, and its folder in the line. */
  readonly name: string;
  readonly part: string;
  readonly options: SampleOptions;
}

/** A model that was made of a STEP file. */
export interface PartOnScreen {
  /** What it is called on the page, and its folder in the line. */
  readonly name: string;
  /** The STEP file, as it was dropped. */
  readonly path: string;
  readonly options: ImportOptions;
  readonly bodies?: readonly number[];
}

/** A submission that was fitted here, alike for several models. */
export interface FitOnScreen {
  readonly request: FitRequest;
  /** The samples that were fitted, by their names. */
  readonly samples: readonly string[];
  /** Whether every model that was brought, parts from CAD among them, was fitted so. */
  readonly brought: boolean;
}

export interface OnScreen {
  /** Paths of the files that were brought, as they were dropped. */
  readonly paths: readonly string[];
  readonly samples: readonly SampleOnScreen[];
  readonly parts: readonly PartOnScreen[];
  readonly fits: readonly FitOnScreen[];
  /** What the reader corrected about files, by path. */
  readonly corrections: Readonly<Record<string, Override>>;
  readonly protocol: Protocol;
}

/** The line, to be run where the dropped files and folders are; undefined where there is nothing to repeat. */
export function commandLine({ paths: all, samples, parts, fits, corrections, protocol }: OnScreen): string | undefined {
  const paths = beside(all, parts);
  const imports = parts.map((part) => ({ out: outOf(part), line: importing(part) }));
  const made = [...new Set(imports.map(({ out }) => out))];
  const places = [...samples.map(({ name }) => name), ...made, ...roots(paths)];
  if (places.length === 0) return undefined;
  const choice = protocol === "definition" ? [] : ["--protocol", protocol];
  const corrected = paths.flatMap((file) => correction(file, corrections[file] ?? {}));
  const fitted = fits.map(({ request, samples: own, brought }) => fit(request, [...own, ...(brought ? [...made, ...roots(paths)] : [])]));
  const scored = [...places, ...(fits.length > 0 ? [FITS] : [])];
  const score = ["fit4cad", "score", ...scored.map(path), ...choice, ...corrected].join(" ");
  const imported = new Set(imports.map(({ line }) => line));
  return [...samples.map(generate), ...imported, ...fitted, score].join(" && ");
}

/** The folder that fits are written to. */
const FITS = "fits";

function fit({ method, parameters, seed }: FitRequest, places: readonly string[]): string {
  const given = Object.entries(parameters).flatMap(([name, value]) => [`--${name.replaceAll("_", "-")}`, String(value)]);
  return ["fit4cad", "fit", ...places.map(path), "--method", method, ...given, "--seed", String(seed), "--out", FITS].join(" ");
}

/** The paths that are not files made of a part. */
export function beside(paths: readonly string[], parts: readonly PartOnScreen[]): readonly string[] {
  return paths.filter((each) => !parts.some((part) => each.startsWith(`${part.path}/`)));
}

/** What a part is imported from: its file, or the zip that it came in, whole. */
export function sourceOf({ path: whole }: PartOnScreen): string {
  return /^[^/]*\.zip(?=\/)/i.exec(whole)?.[0] ?? whole;
}

function outOf(part: PartOnScreen): string {
  const source = sourceOf(part);
  return source === part.path ? part.name : source.replace(/\.zip$/i, "");
}

function importing(part: PartOnScreen): string {
  const { options, bodies } = part;
  const given = Object.entries(options).flatMap(([name, value]) => (value === true ? [`--${name}`] : [`--${name}`, String(value)]));
  const some = bodies === undefined ? [] : ["--bodies", bodies.join(",")];
  return ["fit4cad", "import", path(sourceOf(part)), ...given, ...some, "--out", path(outOf(part))].join(" ");
}

function generate({ name, part, options }: SampleOnScreen): string {
  const given = SAMPLE_OPTIONS.flatMap(({ name: option }) => {
    const value = options[option];
    return value === undefined ? [] : [`--${option}`, String(value)];
  });
  const called = name === part ? [] : ["--name", quoted(name)];
  return ["fit4cad", "generate", quoted(part), ...given, "--imperfect", ...called, "--out", path(name)].join(" ");
}

function correction(file: string, override: Override): string[] {
  const said = (["role", "model", "method", "first"] as const).flatMap((key) => {
    const value = override[key];
    return value === undefined ? [] : `${key}=${String(value).replace(/[%,:]/g, encodeURIComponent)}`;
  });
  return said.length === 0 ? [] : ["--as", quoted(`${said.join(",")}:${file}`)];
}

/** What was dropped: whole folders and zips, and loose files. */
export function roots(paths: readonly string[]): string[] {
  const first = paths.map((whole) => whole.split("/")[0] ?? whole);
  return [...new Set(first)].sort((a, b) => a.localeCompare(b, "en", { numeric: true }));
}

/** A name that begins with a dash would be taken for an option. */
function path(name: string): string {
  return quoted(name.startsWith("-") ? `./${name}` : name);
}

/** As one word of a POSIX shell, whatever characters it holds. */
function quoted(word: string): string {
  return /^[\w@%+=:,./-]+$/.test(word) ? word : `'${word.replaceAll("'", `'\\''`)}'`;
}
