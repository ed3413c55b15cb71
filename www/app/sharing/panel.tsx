// The figures a link claims, each with how far it is borne out here.

import type { JSX } from "preact";
import { byMethod, meanOf } from "../../../bin/formats/measures.mjs";
import { measureColumn } from "../measures/column";
import { MEASURES } from "../measures/measures";
import { selectedMethod, selectedModel, selectModel } from "../state/selection";
import { words } from "../ui/columns";
import * as format from "../ui/format";
import { Icon } from "../ui/icon";
import { Table, type Column } from "../ui/table";
import { VerdictMark } from "./mark";
import type { Difference, Figure } from "./judge";
import { judged, opened, type JudgedClaim } from "./opened";
import { entryOf, failed, fitsOf } from "./rebuild";

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
            As claimed by a link, {protocol === "published" ? "as the published tables were made" : "by definition"}, with
            engine {engine}. {format.plural(judged.value.length, "row")}.
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

function Means(): JSX.Element {
  const claims = judged.value.map(({ claim }) => claim);
  return (
    <>
      {byMethod(claims).map(({ method, own }) => (
        <tr key={method}>
          <th scope="row">Mean of {own.length}</th>
          <td>{method}</td>
          <td colSpan={4} />
          {MEASURES.map((measure) => (
            <td key={measure} class="numeric">
              {format.measure(measure, meanOf(own, measure))}
            </td>
          ))}
          <td class="numeric">{own.reduce((sum, { typeErrors }) => sum + typeErrors, 0)}</td>
        </tr>
      ))}
    </>
  );
}
