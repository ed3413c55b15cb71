// The primitives of one segmentation where there is no other to compare it with: what a method found
// without ground truth, or the ground truth without a submission.

import type { JSX } from "preact";
import { signal } from "@preact/signals";
import type { PrimitiveInfo, SurfaceInfo } from "../engine/contract";
import { measureColumn } from "../measures/column";
import { predictionColours } from "../stage/colouring";
import { scene } from "../state/scene";
import { hoveredPrimitive, selectedModel, selectedPrimitive, togglePrimitive, type PrimitiveRef } from "../state/selection";
import type { ModelScene } from "../../worker/protocol";
import { count, words } from "../ui/columns";
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
  words("type", "Type", ({ primitive }) => primitive.type, { missing: "other" }),
  count("size", "Points", ({ primitive }) => primitive.size),
  measureColumn<Row>("MFE", ({ primitive }) => primitive.mfe),
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

/** Whose primitives they are. */
function alone({ truth, prediction, method }: ModelScene) {
  if (prediction) {
    const whose = `by ${method ?? "a method"}; there is no ground truth to score against`;
    return { side: "prediction", found: prediction.primitives, whose } as const;
  }
  return truth && ({ side: "truth", found: truth.primitives, whose: "in the ground truth; there is no submission to score" } as const);
}

export function FoundPrimitives(): JSX.Element {
  const state = scene.value;
  const shown = state.kind === "ready" ? alone(state.scene) : undefined;
  if (!shown) return <p class="empty">Choose a model that has a ground truth or a submission, or fit one under Fit.</p>;
  const { side, found, whose } = shown;
  const colours = predictionColours(undefined, found.length);
  const rows = found.map((primitive, index): Row => ({ index, primitive, colour: colours[index] ?? UNSEGMENTED }));
  const isRow = (ref: PrimitiveRef | undefined, { index }: Row) => ref?.side === side && ref.index === index;
  return (
    <Table
      className="primitives"
      caption={`${format.plural(rows.length, "primitive")} of ${selectedModel.value} ${whose}`}
      columns={COLUMNS}
      rows={rows}
      keyOf={({ index }) => String(index)}
      sorting={sorting}
      isSelected={(row) => isRow(selectedPrimitive.value, row)}
      isHovered={(row) => isRow(hoveredPrimitive.value, row)}
      onSelect={({ index }) => togglePrimitive({ side, index })}
      onHover={(row) => (hoveredPrimitive.value = row && { side, index: row.index })}
    />
  );
}
