// SHREC 2022's tables: each true primitive as a segment, told by type and measured, of all and by stratum.

import type { JSX } from "preact";
import { useEffect } from "preact/hooks";
import { RECOGNITION } from "../../generated/declared/recognition.js";
import { fittedHeads, RATES } from "../../shared/formats/field.mjs";
import { infoOf } from "../../shared/formats/field-sums.mjs";
import type { FieldStrata } from "../../worker/protocol";
import * as format from "../ui/format";
import { count, words } from "../ui/columns";
import { Table, type Column } from "../ui/table";
import { followStrata, scale, strata } from "./state";

type Row = FieldStrata["segments"][number];
type Spread = Row["mfe"];

export default function SegmentsView(): JSX.Element {
  useEffect(followStrata, []);
  const found = strata.value;
  if (!found) return <p class="empty">Setting segments beside their answers…</p>;
  const { title, definition, rewards, trap, source } = RECOGNITION;
  return (
    <>
      <p class="note">
        {title}. {definition}
      </p>
      <SegmentTable caption={`${title}: all segments`} rows={found.segments} />
      <SegmentTable caption={`${title}: segments by ${found.by}`} rows={found.segmentsByStratum} stratum={infoOf(found.by).title} />
      <section class="rewards" aria-label={`What ${title} rewards`}>
        <details>
          <summary>
            <b>{title}.</b> {rewards}
          </summary>
          <dl>
            <dt>Trap</dt>
            <dd>{trap}</dd>
            <dt>Source</dt>
            <dd>{source}</dd>
            <dt>Strata</dt>
            <dd>{infoOf(found.by).how}</dd>
          </dl>
        </details>
      </section>
    </>
  );
}

function SegmentTable({ caption, rows, stratum }: { caption: string; rows: readonly Row[]; stratum?: string }): JSX.Element {
  const columns: readonly Column<Row>[] = [
    ...(stratum === undefined ? [] : [words<Row>("stratum", stratum, (row) => row.stratum)]),
    words("method", "Method", ({ method }) => method),
    count("segments", "Segments", ({ segments }) => segments),
    ...RATES.map(
      (rate): Column<Row> => ({
        id: rate,
        head: rate,
        label: rate,
        numeric: true,
        cell: ({ rates }) => rates[rate]?.toFixed(4) ?? format.MISSING,
        sortBy: ({ rates }) => rates[rate],
      }),
    ),
    ...fittedHeads(scale.value).map(
      ([key, head]): Column<Row> => ({
        id: key,
        head,
        label: head,
        numeric: true,
        cell: (row) => <Median spread={row[key]} segments={row.segments} />,
        sortBy: (row) => row[key]?.median,
      }),
    ),
  ];
  return (
    <Table className="field" caption={caption} columns={columns} rows={rows} keyOf={(row) => `${row.method} ${row.stratum}`} />
  );
}

/** The median, which does not explode, over the mean, which does. */
function Median({ spread, segments }: { spread: Spread; segments: number }): JSX.Element {
  if (!spread) return <>{format.MISSING}</>;
  return (
    <>
      {spread.median.toExponential(2)}
      <small class="aside">mean {spread.mean.toExponential(2)}</small>
      {spread.count < segments && (
        <small class="aside">
          of {format.integer(spread.count)}
        </small>
      )}
    </>
  );
}
