// The primitives of one segmentation where there is no other to compare it with: what a method found
// without ground truth, or the ground truth without a submission.

import type { JSX } from "preact";
import { signal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import type { PrimitiveInfo, StandardErrorsInfo, SurfaceInfo } from "../engine/contract";
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
import { offBy, plusMinus } from "./plus-minus";
import { errorsOf, follow, isLoose } from "./sure";

interface Row {
  readonly index: number;
  readonly primitive: PrimitiveInfo;
  readonly colour: string;
  /** Standard errors, once they are known. */
  readonly errors: StandardErrorsInfo | undefined;
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
    cell: ({ primitive, errors }) =>
      primitive.surface && (isLoose(primitive, errors) ? <Loose /> : dimensions(primitive.surface, errors)),
  },
];

/** Of what was fitted, and so may be off. */
const ERRORS: readonly Column<Row>[] = [
  {
    id: "position-error",
    head: "Position",
    label: "standard error of the position",
    cell: ({ primitive, errors }) => !isLoose(primitive, errors) && offBy(errors?.position),
    sortBy: ({ errors }) => errors?.position ?? undefined,
  },
  {
    id: "axis-error",
    head: "Axis",
    label: "standard error of the axis",
    cell: ({ primitive, errors }) => !isLoose(primitive, errors) && degrees(errors?.axis),
    sortBy: ({ errors }) => errors?.axis ?? undefined,
  },
];

const DEGREE = Math.PI / 180;

function degrees(error: number | null | undefined): string {
  const told = offBy(error && error / DEGREE);
  return told && `${told}°`;
}

/** The lengths and angles that a draughtsman would note, in the units of the file. */
function dimensions(surface: SurfaceInfo, errors: StandardErrorsInfo | undefined): string {
  switch (surface.type) {
    case "Plane":
      return "";
    case "Cylinder":
    case "Sphere":
      return `radius ${plusMinus(surface.radius, errors?.radius)}`;
    case "Cone":
      return `half-angle ${plusMinus(surface.halfAngle / DEGREE, errors?.halfAngle && errors.halfAngle / DEGREE)}°`;
    case "Torus":
      return `radii ${plusMinus(surface.majorRadius, errors?.radius)} and ${plusMinus(surface.minorRadius, errors?.minorRadius)}`;
  }
}

/** In place of numbers that say nothing. */
function Loose(): JSX.Element {
  return (
    <span class="hint" title="Surfaces that are very different from it fit its points as well">
      undetermined
    </span>
  );
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
  useEffect(follow, []);
  const state = scene.value;
  const shown = state.kind === "ready" ? alone(state.scene) : undefined;
  if (!shown) return <p class="empty">Choose a model that has a ground truth or a submission, or fit one under Fit.</p>;
  const { side, found, whose } = shown;
  const colours = predictionColours(undefined, found.length);
  const errors = side === "prediction" && state.kind === "ready" ? errorsOf(state.scene) : undefined;
  const rows = found.map((primitive, index): Row => ({ index, primitive, colour: colours[index] ?? UNSEGMENTED, errors: errors?.[index] }));
  const isRow = (ref: PrimitiveRef | undefined, { index }: Row) => ref?.side === side && ref.index === index;
  return (
    <Table
      className="primitives"
      caption={`${format.plural(rows.length, "primitive")} of ${selectedModel.value} ${whose}`}
      columns={side === "prediction" ? [...COLUMNS, ...ERRORS] : COLUMNS}
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
