// The command line that repeats what is on screen.

import { SAMPLE_OPTIONS } from "../../generated/declared/sample-options.js";
import type { FitRequest } from "../../worker/protocol";
import type { Override, Protocol, SampleOptions } from "../engine/contract";

/** A sample on the page, with the imperfect submission it comes with. */
export interface SampleOnScreen {
  /** What it is called on the page, and its folder in the line. */
  readonly name: string;
  readonly part: string;
  readonly options: SampleOptions;
}

/** A submission that was fitted here, alike for several models. */
export interface FitOnScreen {
  readonly request: FitRequest;
  /** The samples that were fitted, by their names. */
  readonly samples: readonly string[];
  /** Whether every model that was brought was fitted so. */
  readonly brought: boolean;
}

export interface OnScreen {
  /** Paths of the files that were brought, as they were dropped. */
  readonly paths: readonly string[];
  readonly samples: readonly SampleOnScreen[];
  readonly fits: readonly FitOnScreen[];
  /** What the reader corrected about files, by path. */
  readonly corrections: Readonly<Record<string, Override>>;
  readonly protocol: Protocol;
}

/** The line, to be run where the dropped files and folders are; undefined where there is nothing to repeat. */
export function commandLine({ paths, samples, fits, corrections, protocol }: OnScreen): string | undefined {
  const places = [...samples.map(({ name }) => name), ...roots(paths)];
  if (places.length === 0) return undefined;
  const choice = protocol === "definition" ? [] : ["--protocol", protocol];
  const corrected = paths.flatMap((file) => correction(file, corrections[file] ?? {}));
  const fitted = fits.map(({ request, samples: own, brought }) => fit(request, [...own, ...(brought ? roots(paths) : [])]));
  const all = [...places, ...(fits.length > 0 ? [FITS] : [])];
  const score = ["fit4cad", "score", ...all.map(path), ...choice, ...corrected].join(" ");
  return [...samples.map(generate), ...fitted, score].join(" && ");
}

/** The folder that fits are written to. */
const FITS = "fits";

function fit({ method, parameters, seed }: FitRequest, places: readonly string[]): string {
  const given = Object.entries(parameters).flatMap(([name, value]) => [`--${name.replaceAll("_", "-")}`, String(value)]);
  return ["fit4cad", "fit", ...places.map(path), "--method", method, ...given, "--seed", String(seed), "--out", FITS].join(" ");
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
