// The lines that repeat all this in a terminal, or in Python.

import type { JSX } from "preact";
import { computed } from "@preact/signals";
import { FITTERS } from "../../generated/declared/fitters.js";
import type { FitRequest } from "../../worker/protocol";
import { brought, overrides } from "../state/inbox";
import { fitOf } from "../state/made";
import { scoredRows, type ModelEntry } from "../state/models";
import { protocol } from "../state/settings";
import { stepOf } from "../state/step";
import { commandLine, type FitOnScreen, type OnScreen, type PartOnScreen, type SampleOnScreen } from "./command";
import { copy } from "./download";
import { pythonLines } from "./python";

const entries = computed(() => [...new Set(scoredRows.value.map(({ entry }) => entry))]);

interface Fitted {
  readonly entry: ModelEntry;
  readonly method: string;
  readonly request: FitRequest;
}

const fitted = computed<readonly Fitted[]>(() =>
  scoredRows.value.flatMap(({ entry, reports: { method } }) => {
    const request = fitOf(entry.id, method);
    return request ? [{ entry, method, request }] : [];
  }),
);

/**
 * The fits that a command repeats: it fits all that is in a folder, and names what it finds by the
 * fitter alone.
 */
const repeatable = computed<readonly FitOnScreen[]>(() => {
  if (Object.keys(overrides.value).length > 0) return [];
  const isSample = ({ origin }: ModelEntry) => origin.kind === "sample";
  const others = entries.value.filter((entry) => !isSample(entry)).length;
  return FITTERS.flatMap(({ name, title }): FitOnScreen[] => {
    const own = fitted.value.filter(({ request }) => request.method === name);
    const [first] = own;
    const alike = own.every(({ request, method }) => isSame(request, first?.request) && method === title);
    const brought = own.filter(({ entry }) => !isSample(entry)).length;
    if (!first || !alike || (brought > 0 && brought < others)) return [];
    const samples = own.flatMap(({ entry }) => (isSample(entry) ? [entry.id] : []));
    return [{ request: first.request, samples, brought: brought > 0 }];
  });
});

function isSame(a: FitRequest, b: FitRequest | undefined): boolean {
  const names = new Set([...Object.keys(a.parameters), ...Object.keys(b?.parameters ?? {})]);
  return a.seed === b?.seed && [...names].every((name) => a.parameters[name] === b.parameters[name]);
}

const onScreen = computed((): OnScreen => {
  const samples = entries.value.flatMap(({ id, origin }): SampleOnScreen[] =>
    origin.kind === "sample" ? [{ name: id, part: origin.part, options: origin.options }] : [],
  );
  const parts = entries.value.flatMap((entry): PartOnScreen[] => {
    const { path, options, bodies } = stepOf(entry) ?? {};
    return path === undefined || options === undefined ? [] : [{ name: entry.id, path, options, ...(bodies && { bodies }) }];
  });
  const paths = [...brought.value.keys()];
  return { paths, samples, parts, fits: repeatable.value, corrections: overrides.value, protocol: protocol.value };
});

/** Whether there are submissions that the line cannot make again. */
const isShort = computed(() => fitted.value.some(({ request }) => !repeatable.value.some((fit) => fit.request.method === request.method)));

export function CommandSection(): JSX.Element | null {
  const text = commandLine(onScreen.value);
  const python = pythonLines(onScreen.value);
  if (text === undefined || python === undefined) return null;
  return (
    <section>
      <h3>A command</h3>
      <p>Repeats these results with the same engine, run where the dropped files and folders are.</p>
      <div class="copied-line">
        <code tabIndex={0} data-testid="command">
          {text}
        </code>
        <button type="button" onClick={() => void copy(text, "Command")}>
          Copy as command
        </button>
        <button type="button" title="The same with the Python package fit4cad" onClick={() => void copy(python, "Python")}>
          Copy as Python
        </button>
      </div>
      {isShort.value && (
        <p class="hint">
          Not every submission made on this page is in it: save the others as a zip and add its name to the line.
        </p>
      )}
    </section>
  );
}
