// What a method found where there is no ground truth to compare with.

import type { JSX } from "preact";
import { signal } from "@preact/signals";
import type { PrimitiveInfo, SurfaceInfo } from "../engine/contract";
import { ExplainButton } from "../measures/explain";
import { predictionColours } from "../stage/colouring";
import { scene } from "../state/scene";
import { hoveredPrimitive, selectedModel, selectedPrimitive, togglePrimitive } from "../state/selection";
import * as format from "../ui/format";
import { Swatch } from "../ui/swatch";
import { Table, type Column, type Sorting } from "../ui/table";
import { UNSEGMENTED } from "../view/palette";

interface Row {
  readonly index: number;
  readonly primitive: PrimitiveInfo;
  readonly colour: string;
}

const sorting = signal<Sorting | undefined>(undefined);

const COLUMNS: readonly Column<Row>[] = [
  {
    id: "number",
    head: "Primitive",
    label: "primitive",
    cell: ({ primitive, colour }) => (
      <>
        <Swatch colour={colour} />
        {primitive.number}
      </>
    ),
    sortBy: ({ primitive }) => primitive.number,
  },
  {
    id: "type",
    head: "Type",
    label: "type",
    cell: ({ primitive }) => primitive.type ?? "other",
    sortBy: ({ primitive }) => primitive.type,
  },
  {
    id: "size",
    head: "Points",
    label: "points",
    numeric: true,
    cell: ({ primitive }) => format.integer(primitive.size),
    sortBy: ({ primitive }) => primitive.size,
  },
  {
    id: "MFE",
    head: "MFE",
    aside: <ExplainButton measure="MFE" />,
    label: "MFE",
    numeric: true,
    cell: ({ primitive }) => format.measure("MFE", primitive.mfe),
    sortBy: ({ primitive }) => primitive.mfe,
    title: ({ primitive }) => primitive.mfe?.toString(),
  },
  {
    id: "dimensions",
    head: "Dimensions",
    label: "dimensions",
    cell: ({ primitive }) => primitive.surface && dimensions(primitive.surface),
  },
];

/** The lengths and angles that a draughtsman would note, in the units of the file. */
function dimensions(surface: SurfaceInfo): string {
  const length = (value: number) => value.toPrecision(5);
  switch (surface.type) {
    case "Plane":
      return "";
    case "Cylinder":
    case "Sphere":
      return `radius ${length(surface.radius)}`;
    case "Cone":
      return `half-angle ${((surface.halfAngle * 180) / Math.PI).toFixed(2)}°`;
    case "Torus":
      return `radii ${length(surface.majorRadius)} and ${length(surface.minorRadius)}`;
  }
}

export function FoundPrimitives(): JSX.Element {
  const state = scene.value;
  const found = state.kind === "ready" ? state.scene.prediction?.primitives : undefined;
  if (state.kind !== "ready" || !found) return <p class="empty">Choose a model that has a submission, or fit one under Fit.</p>;
  const colours = predictionColours(undefined, found.length);
  const rows = found.map((primitive, index): Row => ({ index, primitive, colour: colours[index] ?? UNSEGMENTED }));
  const isRow = (ref: typeof selectedPrimitive.value, { index }: Row) => ref?.side === "prediction" && ref.index === index;
  return (
    <Table
      className="primitives"
      caption={`${format.plural(rows.length, "primitive")} of ${selectedModel.value} by ${state.scene.method}; there is no ground truth to score against`}
      columns={COLUMNS}
      rows={rows}
      keyOf={({ index }) => String(index)}
      sorting={sorting}
      isSelected={(row) => isRow(selectedPrimitive.value, row)}
      isHovered={(row) => isRow(hoveredPrimitive.value, row)}
      onSelect={({ index }) => togglePrimitive({ side: "prediction", index })}
      onHover={(row) => (hoveredPrimitive.value = row && { side: "prediction", index: row.index })}
    />
  );
}
