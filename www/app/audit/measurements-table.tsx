// What the audit measured of the selected model, primitive by primitive.

import type { JSX } from "preact";
import type { FormAudit, PrimitiveAudit } from "../engine/contract";
import { selectedPrimitive, togglePrimitive } from "../state/selection";
import { count, words } from "../ui/columns";
import { MISSING } from "../ui/format";
import { Table, type Column } from "../ui/table";
import { ofDiagonal } from "./share";

interface Row extends PrimitiveAudit {
  readonly place: number;
}

const measured = (id: string, head: string, label: string, of: (row: Row) => number | null | undefined): Column<Row> => ({
  id,
  head,
  label,
  numeric: true,
  cell: (row) => ofDiagonal(of(row)),
  sortBy: of,
  title: (row) => of(row)?.toString(),
});

const form = (name: "parametric" | "implicit", title: string): Column<Row>[] => {
  const part = (of: keyof Omit<FormAudit, "euclidean">) => (row: Row) => row[name]?.[of];
  return [
    measured(`${name}-mean`, `${title}, mean`, `mean distance to the ${name} form`, part("mean")),
    measured(`${name}-max`, "largest", `largest distance to the ${name} form`, part("max")),
    measured(`${name}-misfit`, "misfit", `how far the ${name} vector is from a surface of its type`, part("misfit")),
  ];
};

const COLUMNS: readonly Column<Row>[] = [
  {
    id: "number",
    head: "Primitive",
    label: "primitive",
    numeric: true,
    cell: ({ number }) => number,
    sortBy: ({ number }) => number,
  },
  words("type", "Type", ({ type }) => type, { missing: "other" }),
  count("points", "Points", ({ points }) => points),
  count("off", "Off both", ({ off }) => off, { label: "points off every form" }),
  ...form("parametric", "Parametric"),
  ...form("implicit", "Implicit"),
  measured("first-order", "First order", "mean first-order distance |f| / |∇f| to the implicit form", ({ firstOrder }) => firstOrder),
  measured("agreement", "Between forms", "largest distance between the two forms at the points", ({ agreement }) => agreement),
];

export function MeasurementsTable({ model, primitives }: { model: string; primitives: readonly PrimitiveAudit[] }): JSX.Element {
  return (
    <Table
      caption={`Distances of the points of ${model} to both forms, over each primitive's diagonal; ${MISSING} where a form is missing or unusable`}
      columns={COLUMNS}
      rows={primitives.map((primitive, place) => ({ ...primitive, place }))}
      keyOf={({ place }) => String(place)}
      isSelected={({ place }) => selectedPrimitive.value?.side === "truth" && selectedPrimitive.value.index === place}
      onSelect={({ place }) => togglePrimitive({ side: "truth", index: place })}
    />
  );
}
