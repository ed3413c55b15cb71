// True primitives by how large they are, or of which type: where a method wins and loses.

import type { JSX } from "preact";
import type { FieldSums } from "../../worker/protocol";
import * as format from "../ui/format";
import { count, words } from "../ui/columns";
import { Table, type Column } from "../ui/table";

type Row = FieldSums["strata"]["size"][number];

export function StrataTable({ by, rows }: { by: "size" | "type"; rows: readonly Row[] }): JSX.Element {
  const columns: readonly Column<Row>[] = [
    words("stratum", by === "size" ? "Size of the primitive" : "Type", ({ stratum }) => stratum),
    words("method", "Method", ({ method }) => method),
    count("primitives", "Primitives", ({ primitives }) => primitives),
    {
      id: "iou",
      head: "Mean IoU",
      label: "mean IoU",
      numeric: true,
      cell: ({ iou }) => (
        <>
          {iou ? iou.mean.toFixed(4) : format.MISSING}
          {iou?.interval && (
            <small class="aside" title="Bootstrap 95 % interval of the mean">
              {iou.interval[0].toFixed(4)} – {iou.interval[1].toFixed(4)}
            </small>
          )}
        </>
      ),
      sortBy: ({ iou }) => iou?.mean,
      share: ({ iou }) => iou?.mean,
    },
    {
      id: "median",
      head: "Median IoU",
      label: "median IoU",
      numeric: true,
      cell: ({ iou }) => iou?.median.toFixed(4) ?? format.MISSING,
      sortBy: ({ iou }) => iou?.median,
    },
    {
      id: "found",
      head: "IoU > 0.5",
      label: "share with IoU above 0.5",
      numeric: true,
      cell: ({ found }) => format.share(found),
      sortBy: ({ found }) => found,
    },
  ];
  return (
    <Table
      className="field"
      caption={`True primitives by ${by}: IoU with the one-to-one partner, 0 without one`}
      columns={columns}
      rows={rows}
      keyOf={({ method, stratum }) => `${method} ${stratum}`}
    />
  );
}
