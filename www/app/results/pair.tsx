// Two methods, model by model: who wins how often, and whether that is more than chance.

import type { JSX } from "preact";
import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { rowsOf } from "../../shared/formats/measures.mjs";
import { FIGURES } from "../../generated/declared/figures.js";
import type { Entry } from "../../shared/results/scores.mjs";
import { engine } from "../engine/client";
import type { Comparison, FieldReport, Protocol } from "../engine/contract";
import { PROTOCOLS } from "../measures/protocols";
import * as format from "../ui/format";
import { words } from "../ui/columns";
import { Table, type Column } from "../ui/table";
import type { Figure, View } from "./columns";
import { rowOf, ROWS, scoresOf, summaryOf, type Row } from "./table-data";

/** What the engine says of two methods by one figure. */
type Paired = Omit<Comparison, "measure">;

type Answer =
  | { readonly kind: "asking" }
  | { readonly kind: "failed"; readonly message: string }
  | { readonly kind: "answered"; readonly models: number; readonly by: ReadonlyMap<string, Paired> };

interface Props {
  readonly set: string;
  readonly view: View;
}

export function PairSection({ set, view }: Props): JSX.Element | null {
  const one = useSignal("");
  const other = useSignal("");
  const able = ROWS.filter((row) => summaryOf(row, set) !== undefined);
  if (able.length < 2) return null;
  const [left, right] = [one.value, other.value].map((id) => able.find((row) => row.id === id));
  const choose = (label: string, value: { value: string }) => (
    <label>
      {label}{" "}
      <select value={value.value} onChange={(event) => (value.value = event.currentTarget.value)}>
        <option value="">choose…</option>
        {able.map(({ id, method }) => (
          <option key={id} value={id}>
            {method.name}
          </option>
        ))}
      </select>
    </label>
  );
  return (
    <section class="results-pair" aria-label="Two methods compared">
      <h3>Two methods, model by model</h3>
      <div class="panel-tools">
        {choose("Compare", one)}
        {choose("with", other)}
      </div>
      {left && right && left !== right ? (
        <Pair key={`${left.id} ${right.id} ${set} ${view.name}`} left={left} right={right} set={set} view={view} />
      ) : (
        <p class="hint">Choose two methods: wins, ties and losses over the models that both have, with Wilcoxon’s signed-rank test.</p>
      )}
    </section>
  );
}

function Pair({ left, right, set, view }: Props & { left: Row; right: Row }): JSX.Element {
  const answer = useSignal<Answer>({ kind: "asking" });
  useEffect(() => {
    let wanted = true;
    compared([left.id, right.id], set, view).then(
      (found) => wanted && (answer.value = found),
      (error: unknown) => wanted && (answer.value = { kind: "failed", message: error instanceof Error ? error.message : String(error) }),
    );
    return () => {
      wanted = false;
    };
  }, []);
  const found = answer.value;
  if (found.kind === "asking") return <p class="empty">Comparing…</p>;
  if (found.kind === "failed") return <p role="alert">They could not be compared: {found.message}. Check the connection and choose again.</p>;
  const rows = view.figures.flatMap((figure) => {
    const paired = found.by.get(figure.key);
    return paired ? [{ figure, paired }] : [];
  });
  return (
    <>
      <Table
        className="scores differences"
        caption={`${left.method.name} minus ${right.method.name}, ${format.plural(found.models, "model")}`}
        columns={COLUMNS}
        rows={rows}
        keyOf={({ figure }) => figure.key}
      />
      <p class="hint">
        ▲ the first method is better, ▼ the second. p is that of Wilcoxon’s signed-rank test, two-sided: below 0.05 chance alone is
        unlikely, unless many figures are looked at.
      </p>
    </>
  );
}

const MARKS = { better: "▲", worse: "▼", even: "=" } as const;

interface PairRow {
  readonly figure: Figure;
  readonly paired: Paired;
}

const COLUMNS: readonly Column<PairRow>[] = [
  words("figure", "Figure", ({ figure }) => figure.title),
  {
    id: "mean",
    head: "Mean difference",
    label: "mean difference",
    numeric: true,
    cell: ({ figure, paired: { mean } }) =>
      mean ? (
        <span class="difference" data-outcome={mean.outcome}>
          {mean.outcome === "even" ? "0" : `${mean.by > 0 ? "+" : "−"}${figure.write(Math.abs(mean.by))}`} <span aria-hidden="true">{MARKS[mean.outcome]}</span>
          <span class="visually-hidden">{mean.outcome}</span>
        </span>
      ) : (
        format.MISSING
      ),
    sortBy: ({ paired: { mean } }) => mean?.by,
  },
  {
    id: "wins",
    head: "Won, even, lost",
    label: "models won",
    numeric: true,
    cell: ({ paired: { better, even, worse } }) => `${better}, ${even}, ${worse}`,
    sortBy: ({ paired: { better } }) => better,
  },
  {
    id: "p",
    head: "p (Wilcoxon)",
    label: "probability of chance",
    numeric: true,
    cell: ({ paired: { test } }) => format.probability(test?.probability),
    sortBy: ({ paired: { test } }) => test?.probability,
    title: ({ paired: { test } }) => (test ? `${format.plural(test.pairs, "difference")}, ${test.exact ? "counted exactly" : "normal distribution"}` : undefined),
  },
];

async function compared([one, other]: readonly [string, string], set: string, view: View): Promise<Answer> {
  const [own, theirs] = await Promise.all([one, other].map(async (id) => (await scoresOf(id)).sets.find((each) => each.set === set)?.models ?? []));
  const pairs = (own ?? []).flatMap((entry) => {
    const partner = theirs?.find(({ model }) => model === entry.model);
    return partner ? [[entry, partner] as const] : [];
  });
  const [left, right] = [pairs.map(([entry]) => entry), pairs.map(([, entry]) => entry)];
  const protocol = PROTOCOLS.find(({ name }) => name === view.name)?.name;
  const by = protocol ? await byMeasure(left, right, protocol) : await byFigure([one, left], [other, right]);
  return { kind: "answered", models: pairs.length, by };
}

async function byMeasure(left: readonly Entry[], right: readonly Entry[], protocol: Protocol): Promise<ReadonlyMap<string, Paired>> {
  const figures = (entries: readonly Entry[]) => rowsOf(entries.map((entry) => (measure) => entry[protocol][measure]));
  const [own, theirs] = [figures(left), figures(right)];
  const found = await engine.run((api) => api.compare(own, theirs));
  return new Map(found.map((comparison) => [comparison.measure, comparison]));
}

async function byFigure(...sides: readonly (readonly [string, readonly Entry[]])[]): Promise<ReadonlyMap<string, Paired>> {
  const reports = sides.flatMap(([id, entries]) => entries.map((entry) => reportOf(id, entry)));
  const wanted = FIGURES.map(({ key, title, better }) => ({ key, title, better }));
  const { comparisons } = await engine.run((api) => api.fieldSums(reports, wanted));
  return new Map(comparisons.map((comparison) => [comparison.figure, comparison]));
}

/** What the table keeps of a report. */
function reportOf(method: string, { model, figures }: Entry): FieldReport {
  const known = Object.fromEntries(FIGURES.map(({ key }) => [key, figures[key] ?? null])) as FieldReport["figures"];
  return { model, method: rowOf(method)?.id ?? method, scale: { normalisation: "", epsilon: 0 }, figures: known, types: { truth: [], match: [], counts: [] }, primitives: [] };
}
