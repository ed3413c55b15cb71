// The figures a link claims, each with how far it is borne out here.

import type { JSX } from "preact";
import { computed } from "@preact/signals";
import { meanOf, ofSeveral } from "../../shared/formats/measures.mjs";
import { measureColumn } from "../measures/column";
import { MEASURES } from "../measures/measures";
import { rulesOf } from "../measures/protocols";
import { useSummaries } from "../scores/summaries";
import { selectedMethod, selectedModel, selectModel } from "../state/selection";
import { words } from "../ui/columns";
import * as format from "../ui/format";
import { Icon } from "../ui/icon";
import { Table, type Column } from "../ui/table";
import { VerdictMark } from "./mark";
import type { JudgedClaim } from "./judge";
import type { Difference, Figure } from "./kinds/figures";
import { judged, tallyOf } from "./opened";
import { entryOf, failed, fitsOf } from "./rebuild";
import { opened } from "./state";
import { versionWords } from "./version";

function differenceIn({ verdict }: JudgedClaim, figure: Figure): Difference | undefined {
  return verdict.kind === "differs" ? verdict.differences.find((difference) => difference.figure === figure) : undefined;
}

/** A claimed figure, and the one found here where that is another. */
function Claimed({ row, figure, text }: { row: JudgedClaim; figure: Figure; text: (value: number | null) => string }) {
  const difference = differenceIn(row, figure);
  if (!difference) return null;
  const [claimed, found] = [text(difference.claimed), text(difference.found)];
  // Where the difference is below the digits shown, all digits are.
  const exact = claimed === found;
  return (
    <span class="differs">
      <del>
        <span class="visually-hidden">claimed </span>
        {exact ? String(difference.claimed) : claimed}
      </del>
      <ins>
        <span class="visually-hidden">found here </span>
        {exact ? String(difference.found) : found}
      </ins>
    </span>
  );
}

function count(id: string, head: string, label: string, figure: Figure, value: (row: JudgedClaim) => number): Column<JudgedClaim> {
  const text = (found: number | null) => (found === null ? format.MISSING : format.integer(found));
  return {
    id,
    head,
    label,
    numeric: true,
    cell: (row) => (differenceIn(row, figure) ? <Claimed row={row} figure={figure} text={text} /> : text(value(row))),
    sortBy: value,
  };
}

const COLUMNS: readonly Column<JudgedClaim>[] = [
  words("model", "Model", ({ model }) => model.name),
  words("method", "Method", ({ claim }) => claim.method),
  {
    id: "mark",
    head: "Mark",
    label: "mark",
    cell: (row) => <VerdictMark row={row} />,
    sortBy: ({ verdict }) => verdict.kind,
  },
  count("points", "Points", "points", "points", ({ model }) => model.points),
  count("truth", "True", "true primitives", "truth", ({ model }) => model.truth),
  count("predicted", "Pred.", "predicted primitives", "predicted", ({ claim }) => claim.predicted),
  ...MEASURES.map(
    (measure): Column<JudgedClaim> => ({
      ...measureColumn<JudgedClaim>(measure, ({ claim }) => claim.mean[measure]),
      // What the measures mean is told at the tables of results; here there is the mark to make room for.
      aside: undefined,
      cell: (row) =>
        differenceIn(row, measure) ? (
          <Claimed row={row} figure={measure} text={(value) => format.measure(measure, value)} />
        ) : (
          format.measure(measure, row.claim.mean[measure])
        ),
    }),
  ),
  count("types", "Type err.", "type errors", "type errors", ({ claim }) => claim.typeErrors),
];

export default function SharedPanel(): JSX.Element {
  if (opened.value.kind !== "shared") return <p class="empty">No link is open.</p>;
  const { protocol, engine } = opened.value.results;
  return (
    <>
      <Failures />
      <Table
        className="scores claims"
        caption={
          <>
            As claimed by a link, {rulesOf(protocol)}, with {versionWords(engine)}.{" "}
            {format.plural(judged.value.length, "row")}.
          </>
        }
        columns={COLUMNS}
        rows={judged.value}
        keyOf={({ key }) => key}
        isSelected={({ model, claim }) =>
          selectedModel.value !== undefined && entryOf(model)?.id === selectedModel.value && claim.method === selectedMethod.value
        }
        onSelect={({ model, claim }) => {
          const entry = entryOf(model);
          if (entry) selectModel(entry.id, claim.method);
        }}
        foot={<Means />}
      />
    </>
  );
}

/** Why fits could not be repeated. */
function Failures(): JSX.Element | null {
  if (failed.value.length === 0) return null;
  return (
    <ul class="failures" aria-label="Fits that failed">
      {failed.value.map((failure) => (
        <li key={failure.reason}>
          <Icon name="error" />
          <strong>{fitsOf(failure)}:</strong> {failure.reason}
        </li>
      ))}
    </ul>
  );
}

/** A mean stands no better than the rows it is of. */
function meanStanding(rows: readonly JudgedClaim[]): string {
  const { verified, recomputed, repeated, differs } = tallyOf(rows);
  if (repeated > 0) return `${repeated} of ${rows.length} repeat others`;
  if (differs > 0) return `${differs} of ${rows.length} differ`;
  if (verified === rows.length) return "of verified rows";
  if (recomputed === rows.length) return "of recomputed rows";
  return "as claimed";
}

/** As the formats of tables take them. */
const claimed = computed(() => judged.value.map(({ claim: { method, mean, typeErrors } }) => ({ method, mean, type_errors: typeErrors })));

function Means(): JSX.Element {
  const summaries = useSummaries(claimed.value);
  return (
    <>
      {ofSeveral(summaries).map((summary) => (
        <tr key={summary.method}>
          <th scope="row">Mean of {summary.models}</th>
          <td>{summary.method}</td>
          <td>{meanStanding(judged.value.filter(({ claim }) => claim.method === summary.method))}</td>
          <td colSpan={3} />
          {MEASURES.map((measure) => (
            <td key={measure} class="numeric">
              {format.measure(measure, meanOf(summary, measure))}
            </td>
          ))}
          <td class="numeric">{summary.typeErrors}</td>
        </tr>
      ))}
    </>
  );
}
