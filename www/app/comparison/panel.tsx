// A method against the paper's two, model by model and in the mean.

import type { JSX } from "preact";
import { computed, effect, signal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { FITTERS } from "../../generated/declared/fitters.js";
import { published, TEST_MODELS } from "../../shared/published/figures.mjs";
import { matchOf, type Match, type Said } from "../../shared/published/match.mjs";
import { PUBLISHED_METHODS, type PublishedMethod } from "../../shared/published/methods.mjs";
import type { Sheets } from "../../shared/formats/sheet.mjs";
import type { Comparison, Difference, Measure } from "../engine/contract";
import { ExplainButton } from "../measures/explain";
import { MEASURES } from "../measures/measures";
import { rulesOf } from "../measures/protocols";
import { methods, scoredRows } from "../state/models";
import { selectedModel, selectModel } from "../state/selection";
import { notify } from "../state/notices";
import { protocol } from "../state/settings";
import { words } from "../ui/columns";
import * as format from "../ui/format";
import { sorted, Table, type Column, type Sorting } from "../ui/table";
import { comparing, type Pair } from "./compare";
import { DifferenceMark } from "./difference";
import type { Candidate } from "./candidate";
import { SaveButtons } from "./save";
import { sheetsOf } from "./sheet";
import { Which } from "./which";

const chosenOwn = signal<string | undefined>(undefined);
const theirMethod = signal<PublishedMethod>("HT");
/** What the reader says a model is, by its name on the page. */
const said = signal<Readonly<Record<string, Said>>>({});

/** The chosen method, else the first that is not one of the published ones, else the first. */
const ownMethod = computed(() => {
  const names = methods.value;
  const isPublished = (name: string) => (PUBLISHED_METHODS as readonly string[]).includes(name);
  return (
    names.find((name) => name === chosenOwn.value) ?? names.find((name) => !isPublished(name)) ?? names[0]
  );
});

interface Row extends Candidate {
  readonly match: Extract<Match, { kind: "matched" }>;
}

const candidates = computed<readonly Candidate[]>(() =>
  scoredRows.value
    .filter(({ reports }) => reports.method === ownMethod.value)
    .map(({ entry, reports }) => {
      const report = reports[protocol.value];
      const model = { name: entry.id, points: report.points, truth: report.truth };
      return { entry, report, match: matchOf(model, TEST_MODELS, said.value[entry.id]) };
    }),
);

const rows = computed(() => candidates.value.filter((candidate): candidate is Row => candidate.match.kind === "matched"));

/** What the two are called: those of one name are told apart. */
const sides = computed(() => {
  const [own, theirs] = [ownMethod.value ?? "", theirMethod.value];
  return { own: own === theirs ? `your ${own}` : own, theirs: `the published ${theirs}` };
});

/** The largest losses first: what is to be looked at. */
const sorting = signal<Sorting | undefined>({ column: "DSC" satisfies Measure, descending: false });

function pairOf({ report, match }: Row): Pair {
  return {
    own: (measure) => report.mean[measure],
    theirs: (measure) => published(match.model, theirMethod.value, protocol.value, measure),
  };
}

const { compared, ask } = comparing(pairOf);

/** Compares what there is to compare, and what comes, until the result is called. */
function follow(): () => void {
  return effect(() => {
    ask(rows.value).catch((error: unknown) => notify(error instanceof Error ? error.message : String(error), "error"));
  });
}

/** The largest difference of each measure, without its sign. */
const largest = computed(() => {
  const known = compared.value?.by ?? new Map<Measure, Comparison>();
  const of = ({ differences }: Comparison) => Math.max(...differences.map((difference) => Math.abs(difference?.by ?? 0)));
  return new Map([...known].map(([measure, comparison]) => [measure, of(comparison)]));
});

function heatOf(row: Row, measure: Measure): { outcome: "better" | "worse"; share: number } | undefined {
  const difference = differenceOf(row, measure);
  if (!difference || difference.outcome === "even") return undefined;
  return { outcome: difference.outcome, share: Math.abs(difference.by) / (largest.value.get(measure) ?? Infinity) };
}

/** The engine's difference for a row; nothing until it has answered. */
function differenceOf(row: Row, measure: Measure): Difference | null | undefined {
  const known = compared.value;
  return known?.by.get(measure)?.differences[known.rows.indexOf(row)];
}

function titleOf(row: Row, measure: Measure): string {
  const { own, theirs } = pairOf(row);
  const printed = published(row.match.model, theirMethod.value, "paper", measure);
  const paper = printed === null || protocol.value === "definition" ? "" : `, ${printed} in the paper`;
  const figures = `${format.measure(measure, own(measure))} against ${format.measure(measure, theirs(measure))}${paper}`;
  return `${figures}: ${sides.value.own} against ${sides.value.theirs}`;
}

const COLUMNS: readonly Column<Row>[] = [
  words("model", "Model", ({ entry }) => entry.id),
  {
    id: "test",
    head: "Test model",
    label: "test model",
    cell: ({ match }) => (match.said ? `${match.model}, as you say` : match.model),
    sortBy: ({ match }) => match.model,
  },
  ...MEASURES.map(
    (measure): Column<Row> => ({
      id: measure,
      head: measure,
      aside: <ExplainButton measure={measure} />,
      label: `difference in ${measure}`,
      numeric: true,
      cell: (row) => <DifferenceMark measure={measure} difference={differenceOf(row, measure)} />,
      sortBy: (row) => differenceOf(row, measure)?.by,
      heat: (row) => heatOf(row, measure),
      title: (row) => titleOf(row, measure),
    }),
  ),
];

export default function ComparisonPanel(): JSX.Element {
  useEffect(follow, []);
  const own = ownMethod.value;
  if (own === undefined) return <p class="empty">Nothing is scored yet that could be compared.</p>;
  return (
    <div class="comparison">
      <div class="panel-tools">
        <label>
          Compare{" "}
          <select value={own} onChange={(event) => (chosenOwn.value = event.currentTarget.value)}>
            {methods.value.map((name) => (
              <option key={name} value={name}>
                {name === theirMethod.value ? `your ${name}` : name}
              </option>
            ))}
          </select>
        </label>
        <label>
          with the published{" "}
          <select
            value={theirMethod.value}
            onChange={(event) => (theirMethod.value = event.currentTarget.value as PublishedMethod)}
          >
            {PUBLISHED_METHODS.map((name) => (
              <option key={name} value={name}>
                {name} ({FITTERS.find(({ title }) => title === name)?.fullName})
              </option>
            ))}
          </select>
        </label>
        <p>
          The published result files, scored anew{" "}
          {rulesOf(protocol.value)}.
        </p>
        {rows.value.length > 0 && <SaveButtons name={`fit4cad-${own}-against-published-${theirMethod.value}`} sheets={saved} />}
      </div>
      {rows.value.length > 0 ? (
        <Table
          className="scores differences"
          caption={`${format.capitalised(sides.value.own)} minus ${sides.value.theirs}: ▲ better, ▼ worse, shaded by how much. ${format.plural(rows.value.length, "model")}; a row opens its model.`}
          sorting={sorting}
          columns={COLUMNS}
          rows={rows.value}
          keyOf={({ entry }) => entry.id}
          isSelected={({ entry }) => entry.id === selectedModel.value}
          onSelect={({ entry }) => selectModel(entry.id, own)}
          foot={<Foot />}
        />
      ) : (
        <p class="empty">
          None of the models here is one of the 35 test models, for which alone there are published figures.
        </p>
      )}
      <Which candidates={candidates.value} said={said} />
    </div>
  );
}

/** What is saved: the rows as they are sorted, and their sums. */
function saved(engine: string): Sheets {
  const shown = sorted(rows.peek(), COLUMNS, sorting.peek()).map((row) => ({
    ...pairOf(row),
    model: row.entry.id,
    test: row.match.model,
    difference: (measure: Measure) => differenceOf(row, measure),
  }));
  const note = `Fit4CAD Playground ${engine}: ${sides.peek().own} and ${sides.peek().theirs}, scored anew ${rulesOf(protocol.peek())}`;
  return sheetsOf(sides.peek(), shown, compared.peek()?.by ?? new Map<Measure, Comparison>(), note);
}

function Foot(): JSX.Element {
  const of = (measure: Measure) => compared.value?.by.get(measure);
  const line = (head: string, cell: (measure: Measure) => JSX.Element | string) => (
    <tr>
      <th scope="row" colSpan={2}>
        {head}
      </th>
      {MEASURES.map((measure) => (
        <td key={measure} class="numeric">
          {cell(measure)}
        </td>
      ))}
    </tr>
  );
  return (
    <>
      {line("Mean difference", (measure) => (
        <DifferenceMark measure={measure} difference={of(measure)?.mean} />
      ))}
      {line("Won, lost, even", (measure) => {
        const { better, worse, even } = of(measure) ?? { better: 0, worse: 0, even: 0 };
        return better + worse + even === 0 ? format.MISSING : `${better}, ${worse}, ${even}`;
      })}
      {line("p (Wilcoxon)", (measure) => format.probability(of(measure)?.test?.probability))}
      {line(`Mean of ${sides.value.own}`, (measure) => format.measure(measure, of(measure)?.own))}
      {line(`Mean of ${sides.value.theirs}`, (measure) => format.measure(measure, of(measure)?.theirs))}
    </>
  );
}
