// A row per face of every instance: what it is, what is in the cloud of it, and why not more.

import type { JSX } from "preact";
import { signal } from "@preact/signals";
import type { FaceReport, ImportReport } from "../../generated/cad/cad.js";
import { hoveredPrimitive, selectedPrimitive, togglePrimitive, type PrimitiveRef } from "../state/selection";
import { count, words } from "../ui/columns";
import { Swatch } from "../ui/swatch";
import { Table, type Column, type Sorting } from "../ui/table";
import { segmentColour } from "../view/palette";

interface Row extends FaceReport {
  readonly key: string;
}

const sorting = signal<Sorting | undefined>(undefined);

/** `B_SPLINE_SURFACE` as words. */
const inWords = (name: string) => name.toLowerCase().replaceAll("_", " ").replaceAll("+", " + ");

/** With the digits that tell something, from hair-thin faces to halls. */
const area = (value: number) => Number(value.toPrecision(4)).toLocaleString("en", { maximumSignificantDigits: 4 });

const COLUMNS: readonly Column<Row>[] = [
  { id: "face", head: "Face", label: "number of the face in the file", cell: ({ face }) => `#${face}`, sortBy: ({ face }) => face },
  words("body", "Body", ({ body }) => body),
  count("instance", "Instance", ({ instance }) => instance),
  words("surface", "Surface in the file", ({ surface }) => inWords(surface)),
  {
    id: "type",
    head: "Type",
    label: "type",
    cell: ({ type, recognised }) => (type === null ? "none" : recognised ? `${type}, recognised` : type),
    sortBy: ({ type }) => type,
  },
  { id: "area", head: "Area, mm²", label: "area", numeric: true, cell: (row) => area(row.area), sortBy: (row) => row.area },
  count("points", "Points", ({ points }) => points),
  {
    id: "primitive",
    head: "Primitive",
    label: "primitive",
    numeric: true,
    cell: ({ primitive }) =>
      primitive === null ? (
        "none"
      ) : (
        <>
          <Swatch colour={segmentColour(primitive - 1)} />
          {primitive}
        </>
      ),
    sortBy: ({ primitive }) => primitive,
  },
  words("remark", "Remark", ({ remark }) => remark || null),
];

/** Its primitive among the true ones. */
function refOf({ primitive }: Row): PrimitiveRef | undefined {
  return primitive === null ? undefined : { side: "truth", index: primitive - 1 };
}

function isOf(row: Row, ref: PrimitiveRef | undefined): boolean {
  return ref?.side === "truth" && ref.index + 1 === row.primitive;
}

export function Faces({ id, report }: { id: string; report: ImportReport }): JSX.Element {
  const rows = report.faces.map((face, at): Row => ({ ...face, key: String(at) }));
  return (
    <Table
      className="cad-faces"
      caption={`Faces of ${id}`}
      columns={COLUMNS}
      rows={rows}
      keyOf={({ key }) => key}
      sorting={sorting}
      isSelected={(row) => isOf(row, selectedPrimitive.value)}
      isHovered={(row) => isOf(row, hoveredPrimitive.value)}
      onSelect={(row) => {
        const ref = refOf(row);
        if (ref) togglePrimitive(ref);
      }}
      onHover={(row) => (hoveredPrimitive.value = row && refOf(row))}
    />
  );
}
