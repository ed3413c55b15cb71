// The lines of Python that repeat what is on screen.

import { SAMPLE_OPTIONS } from "../../generated/declared/sample-options.js";
import type { Override } from "../engine/contract";
import { beside, roots, sourceOf, type FitOnScreen, type OnScreen, type PartOnScreen, type SampleOnScreen } from "./command";

/** The lines, to be run where the dropped files and folders are; undefined where there is nothing to repeat. */
export function pythonLines({ paths: all, samples, parts, fits, corrections, protocol }: OnScreen): string | undefined {
  if (samples.length === 0 && all.length === 0) return undefined;
  const paths = beside(all, parts);
  const known = Object.entries(corrections).filter(([path]) => paths.includes(path));
  const others = paths.length > 0 ? [[...roots(paths).map(text), ...overrides(known)].join(", ")] : [];
  const brought = [...others, ...new Set(parts.map(imported))];
  return [
    "import fit4cad",
    "",
    `samples = [${samples.map(generated).join("")}${samples.length > 0 ? "\n" : ""}]`,
    ...samples.map(({ options }, at) => `samples[${at}].imperfect(${options.seed ?? 1})`),
    ...brought.map((what, at) => (at === 0 ? `brought = list(fit4cad.read_all(${what}))` : `brought += fit4cad.read_all(${what})`)),
    ...fits.flatMap((fit) => fitted(fit, samples)),
    `reports = fit4cad.score_many(samples${brought.length > 0 ? " + brought" : ""}, ${text(protocol)})`,
    "for report in reports:",
    "    print(report.model, report.method, report.mean)",
  ].join("\n");
}

function generated({ name, part, options }: SampleOnScreen): string {
  const given = SAMPLE_OPTIONS.flatMap(({ name: option }) => {
    const value = options[option];
    return value === undefined ? [] : [`${option}=${value}`];
  });
  const called = name === part ? [] : [`name=${text(name)}`];
  return `\n    fit4cad.generate(${[text(part), ...called, ...given].join(", ")}),`;
}

function imported(part: PartOnScreen): string {
  const given = Object.entries(part.options).map(([name, value]) => `${name}=${typeof value === "string" ? text(value) : value === true ? "True" : value}`);
  const some = part.bodies === undefined ? [] : [`bodies=[${part.bodies.join(", ")}]`];
  return [text(sourceOf(part)), ...given, ...some].join(", ");
}

function overrides(known: readonly (readonly [string, Override])[]): string[] {
  const said = known.map(([path, override]) => {
    const pairs = Object.entries(override).map(([key, value]) => `${text(key)}: ${typeof value === "string" ? text(value) : value}`);
    return `${text(path)}: {${pairs.join(", ")}}`;
  });
  return said.length === 0 ? [] : [`overrides={${said.join(", ")}}`];
}

function fitted({ request: { method, parameters, seed }, samples: own, brought }: FitOnScreen, samples: readonly SampleOnScreen[]): string[] {
  const places = own.map((name) => samples.findIndex((sample) => sample.name === name)).filter((at) => at >= 0);
  const which = places.length === samples.length ? "samples" : `[${places.map((at) => `samples[${at}]`).join(", ")}]`;
  const models = [...(places.length > 0 ? [which] : []), ...(brought ? ["brought"] : [])].join(" + ");
  const given = Object.entries(parameters).map(([name, value]) => `${name}=${value}`);
  return models === "" ? [] : [`for model in ${models}:`, `    model.fit(${[text(method), ...given, `seed=${seed}`].join(", ")})`];
}

/** As a literal of Python; JSON's strings are that, whatever they hold. */
function text(word: string): string {
  return JSON.stringify(word);
}
