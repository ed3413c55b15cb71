// A method's own page: what it is, what it scored on each model, where it fails, how to check and how to cite it.

import type { JSX } from "preact";
import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import type { Work } from "../../../CITATION.cff";
import { authorsOf } from "../../shared/results/feed.mjs";
import { titleOfKind } from "../../shared/results/kinds.mjs";
import type { Entry, SetScores, Stratum } from "../../shared/results/scores.mjs";
import type { ModelSet } from "../../shared/results/sets.mjs";
import { wearWords } from "../../shared/results/wear.mjs";
import { Away, Cited } from "../about/cited";
import { copy } from "../export/download";
import { PROTOCOLS } from "../measures/protocols";
import { writeFragment } from "../sharing/codec/link";
import { goTo, HOME } from "../state/router";
import { notify } from "../state/notices";
import { count, words } from "../ui/columns";
import * as format from "../ui/format";
import { Icon } from "../ui/icon";
import { Table, type Column } from "../ui/table";
import { claimsOf } from "./claims";
import { inOrder, valueOf, VIEWS, type Figure, type View } from "./columns";
import { addressOfMethod, showMethod, shownSet, view } from "./state";
import { scoresOf, setOf, type Row } from "./table-data";
import { secondsText, timeOf } from "./time";
import { onPage, WorstPicture } from "./worst-picture";

/** Of the worst models, how many are told. */
const WORST = 5;

type Answer =
  | { readonly kind: "asking" }
  | { readonly kind: "failed"; readonly message: string }
  | { readonly kind: "answered"; readonly sets: readonly SetScores[] };

export function MethodPage({ row }: { row: Row }): JSX.Element {
  const { method } = row;
  const set = setOf(shownSet.value);
  return (
    <article class="results-method">
      <p>
        <a
          href={addressOfMethod(undefined)}
          onClick={(event) => {
            if (event.ctrlKey || event.metaKey || event.shiftKey) return;
            event.preventDefault();
            showMethod(undefined);
          }}
        >
          ← All methods
        </a>
      </p>
      <h3>{method.name}</h3>
      {method.note !== undefined && <p class="results-note">{method.note}</p>}
      <Facts row={row} />
      {set && <SetFigures key={`${row.id} ${set.id}`} row={row} set={set} />}
      <section>
        <h4>How to cite</h4>
        <Cited work={workOf(row)} what={method.paper ? "the paper" : "the method"} />
        <p class="row">
          <button type="button" onClick={() => void copy(new URL(addressOfMethod(row.id), location.href).href, "Address")}>
            <Icon name="copy" />
            Copy this page’s lasting address
          </button>
        </p>
      </section>
    </article>
  );
}

function Facts({ row: { method } }: { row: Row }): JSX.Element {
  const { answers, time, code } = method;
  return (
    <dl class="results-facts">
      <dt>Authors</dt>
      <dd>
        {authorsOf(method)}, {method.year}
      </dd>
      <dt>Kind</dt>
      <dd>{titleOfKind(method.kind)}</dd>
      <dt>Trained on</dt>
      <dd>{method.trainedOn}</dd>
      {time && (
        <>
          <dt>Time</dt>
          <dd>
            {time.platform}, {time.machine}
            {time.seconds !== undefined && `: ${secondsText(time.seconds)} s a cloud${time.source === undefined ? "" : ` (${time.source})`}`}
          </dd>
        </>
      )}
      <dt>Answers</dt>
      <dd>
        {answers.way === "archive" ? (
          <>
            <Away to={answers.archive}>{answers.archive}</Away>, SHA-256 <code>{answers.sha256}</code>
          </>
        ) : answers.way === "public" ? (
          "in the benchmark’s public repository"
        ) : answers.way === "fitter" ? (
          <>
            made again by <code>fit4cad fit --method {answers.fitter}</code>
          </>
        ) : (
          <>
            as measured by <code>{answers.script}</code>; nobody can make the same again to the digit
          </>
        )}
        ; licence {answers.licence}
      </dd>
      {code !== undefined && (
        <>
          <dt>Code</dt>
          <dd>
            <Away to={code}>{code}</Away>
          </dd>
        </>
      )}
      <dt>In the table since</dt>
      <dd>{method.added}</dd>
    </dl>
  );
}

function SetFigures({ row, set }: { row: Row; set: ModelSet }): JSX.Element {
  const answer = useSignal<Answer>({ kind: "asking" });
  useEffect(() => {
    let wanted = true;
    scoresOf(row.id).then(
      ({ sets }) => wanted && (answer.value = { kind: "answered", sets }),
      (error: unknown) => wanted && (answer.value = { kind: "failed", message: error instanceof Error ? error.message : String(error) }),
    );
    return () => {
      wanted = false;
    };
  }, []);
  const found = answer.value;
  if (found.kind === "asking") return <p class="empty">Loading the figures of each model…</p>;
  if (found.kind === "failed") return <p role="alert">The figures of each model could not be loaded ({found.message}). Check the connection and reload the page.</p>;
  const scores = found.sets.find((each) => each.set === set.id);
  if (!scores) return <p class="empty">{row.method.name} was not scored on “{set.title}”.</p>;
  const shown = VIEWS.find(({ name, figures }) => name === view.value && figures.length > 0) ?? VIEWS[0];
  if (!shown) return <></>;
  return (
    <>
      <Check row={row} set={set} scores={scores} />
      <Worst row={row} set={set} scores={scores} view={shown} />
      <section>
        <h4>By type</h4>
        <div class="results-scroll" role="region" aria-label="By type" tabIndex={0}>
          <Table className="field" caption="True primitives: IoU with the one-to-one partner, 0 without one" columns={STRATA} rows={scores.summary.types} keyOf={({ stratum }) => stratum} />
        </div>
      </section>
      <section>
        <h4>Every model</h4>
        <div class="results-scroll" role="region" aria-label="Every model" tabIndex={0}>
          <Table
            className="field"
            caption={`${format.plural(scores.models.length, "model")}, ${shown.title.toLowerCase()}; engine ${scores.engine}`}
            columns={modelColumns(row, shown)}
            rows={scores.models}
            keyOf={({ model }) => model}
          />
        </div>
      </section>
    </>
  );
}

const STRATA: readonly Column<Stratum>[] = [
  words("type", "Type", ({ stratum }) => stratum),
  count("primitives", "Primitives", ({ primitives }) => primitives),
  {
    id: "iou",
    head: "Mean IoU",
    label: "mean IoU",
    numeric: true,
    cell: ({ iou }) => iou?.mean.toFixed(4) ?? format.MISSING,
    sortBy: ({ iou }) => iou?.mean,
    share: ({ iou }) => iou?.mean,
    title: ({ iou }) => (iou?.interval ? `95 % interval ${iou.interval[0].toFixed(4)} – ${iou.interval[1].toFixed(4)}` : undefined),
  },
  { id: "found", head: "IoU > 0.5", label: "share with IoU above 0.5", numeric: true, cell: ({ found }) => format.share(found), sortBy: ({ found }) => found },
];

function modelColumns(row: Row, shown: View): Column<Entry>[] {
  const hasTimes = timeOf(row, shownSet.value)?.what === "median";
  return [
    words("model", "Model", ({ model }) => model),
    count("points", "Points", ({ points }) => points),
    count("truth", "True", ({ truth }) => truth, { label: "true primitives" }),
    count("predicted", "Pred.", ({ predicted }) => predicted, { label: "predicted primitives" }),
    ...shown.figures.map((figure): Column<Entry> => ({
      id: figure.key,
      head: figure.title,
      label: figure.title,
      numeric: true,
      cell: (entry) => figure.write(valueOf(figure, entry)),
      sortBy: (entry) => valueOf(figure, entry),
      title: (entry) => valueOf(figure, entry)?.toString(),
    })),
    ...(hasTimes
      ? [{ id: "seconds", head: "Seconds", label: "seconds", numeric: true, cell: ({ seconds }: Entry) => (seconds === undefined ? format.MISSING : secondsText(seconds)), sortBy: ({ seconds }: Entry) => seconds }]
      : []),
  ];
}

interface OfSet {
  readonly row: Row;
  readonly set: ModelSet;
  readonly scores: SetScores;
}

/** Where it fails, each of them one click from being looked at. */
function Worst({ row, set, scores, view: shown }: OfSet & { view: View }): JSX.Element | null {
  const [first] = shown.figures;
  if (!first) return null;
  const worst = worstBy(first, scores.models).map((entry) => ({ entry, found: onPage(row, entry) }));
  const isPublic = set.degraded === undefined;
  return (
    <section>
      <h4>
        The {worst.length} worst by {first.title}
      </h4>
      <ul class="results-worst">
        {worst.map(({ entry, found }) => (
          <li key={entry.model}>
            <strong>{entry.model}</strong> {first.title} {first.write(valueOf(first, entry))}, {format.plural(entry.predicted, "primitive")} for {format.integer(entry.truth)}{" "}
            {isPublic && (
              <button type="button" class="link" onClick={() => void openClaims({ row, set, scores }, [entry])}>
                Open {entry.model} in the playground
              </button>
            )}
            {found && <WorstPicture found={found} entry={entry} />}
          </li>
        ))}
      </ul>
      {worst.some(({ found }) => !found) && (
        <p class="row">
          {isPublic && (
            <button type="button" onClick={() => void openClaims({ row, set, scores }, worst.map(({ entry }) => entry))}>
              Open all {worst.length} in the playground
            </button>
          )}
          <span class="hint">
            The table keeps figures alone. Once the files of these models and the method’s answers are in the playground, pictures of them are drawn here.
          </span>
        </p>
      )}
    </section>
  );
}

function worstBy(figure: Figure, entries: readonly Entry[]): readonly Entry[] {
  const last = [...entries].sort((one, other) => inOrder(figure, valueOf(figure, other) ?? undefined, valueOf(figure, one) ?? undefined));
  return last.slice(0, WORST);
}

/** The row as figures that are claimed, which the page checks. */
function Check({ row, set, scores }: OfSet): JSX.Element {
  const { answers } = row.method;
  const how = set.degraded
    ? `Make the set with fit4cad degrade --set ${set.id} (${wearWords(set.degraded)}), and drop it with the answers.`
    : answers.way === "public" || answers.way === "fitter"
      ? "The public files are fetched, each known by its SHA-256, and every digit is computed again in this browser."
      : "Drop the same files on the page, and every digit is computed again in this browser.";
  return (
    <section>
      <h4>Check it yourself</h4>
      <p>
        {how} At the command line: <code>fit4cad verify results/{row.id} --data FOLDER{answers.way === "archive" || answers.way === "script" ? " --answers FOLDER" : ""}</code>
      </p>
      <p class="row">
        <button type="button" class="primary" onClick={() => void openClaims({ row, set, scores }, scores.models)}>
          Open the claimed figures to be verified
        </button>
      </p>
    </section>
  );
}

async function openClaims({ row, set, scores }: OfSet, entries: readonly Entry[]): Promise<void> {
  try {
    const protocol = PROTOCOLS.find(({ name }) => name === view.value)?.name ?? PROTOCOLS[0]?.name ?? "definition";
    const fragment = writeFragment(await claimsOf(row.method, set, scores, entries, protocol));
    goTo(HOME);
    // Opens as any link put into the address does.
    location.hash = fragment;
  } catch (error) {
    notify(error instanceof Error ? error.message : String(error), "error");
  }
}

/** As a bibliography has it: the paper, or the row itself where there is none. */
function workOf({ id, method }: Row): Work {
  const { paper, authors, name, year } = method;
  return {
    type: paper ? "article" : "software",
    title: paper?.title ?? name,
    authors: authors.map((author) => ("name" in author ? author : { "family-names": author.family, "given-names": author.given })),
    year,
    ...(paper?.journal === undefined ? {} : { journal: paper.journal }),
    ...(paper?.doi === undefined ? {} : { doi: paper.doi }),
    url: paper ? (paper.url ?? method.code ?? "") : new URL(addressOfMethod(id), location.href).href,
  };
}
