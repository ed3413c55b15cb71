// Whether small primitives are found as well as large ones.

import type { JSX } from "preact";
import { measureColumn } from "../measures/column";
import { selectedModel, selectedPrimitive } from "../state/selection";
import { count, words } from "../ui/columns";
import * as format from "../ui/format";
import { Table, type Column } from "../ui/table";
import { Chart } from "./figure";
import { drawn, leading, legend, Plot, type Frame } from "./plot";
import { chartedMethod, goTo, scopeText, truePrimitives, type TruePrimitive } from "./scope";
import { TYPES, typeColour, typeName } from "./surface-types";

const COLUMNS: readonly Column<TruePrimitive>[] = [
  words("primitive", "Primitive", ({ model, report }) => `${model}, ${report.truth}`),
  words("type", "Type", ({ report }) => typeName(report.type)),
  count("size", "Points", ({ report }) => report.size),
  measureColumn("DSC", ({ report }) => report.DSC),
];

function visit({ model, method, place }: TruePrimitive): void {
  goTo(model, method, { side: "truth", index: place });
}

function isCurrent({ model, place }: TruePrimitive): boolean {
  const current = selectedPrimitive.value;
  return model === selectedModel.value && current?.side === "truth" && current.index === place;
}

export function SizeChart(): JSX.Element {
  const rows = truePrimitives.value;
  const title = `DSC against size, ${chartedMethod.value}, ${scopeText.value}`;
  return (
    <Chart
      name="size"
      title={title}
      description="Each dot is a true primitive: how many points it has (logarithmic), and how well it was found."
      draw={(frame) => draw(frame, rows)}
      table={() => (
        <Table
          caption={title}
          columns={COLUMNS}
          rows={rows}
          keyOf={({ model, place }) => `${model} ${place}`}
          isSelected={isCurrent}
          onSelect={visit}
        />
      )}
    />
  );
}

function draw(frame: Frame, rows: readonly TruePrimitive[]): SVGSVGElement {
  // A logarithm has no place for an empty primitive.
  const shown = rows.filter(({ report }) => report.size > 0 && report.DSC !== null);
  const current = shown.filter(isCurrent);
  const marginLeft = 40;
  const types = TYPES.filter((name) => shown.some(({ report }) => typeName(report.type) === name));
  const keys = legend(types.map((text) => ({ text, colour: typeColour(text) })), frame, marginLeft);
  const place = { x: ({ report }: TruePrimitive) => report.size, y: ({ report }: TruePrimitive) => report.DSC };
  return drawn(frame, {
    height: 270 + keys.height,
    marginLeft,
    marginTop: keys.height + 4,
    marginBottom: 38,
    marginRight: 16,
    x: { type: "log", label: "Points →", nice: true },
    y: { domain: [0, 1], label: null },
    marks: [
      Plot.gridY({ stroke: frame.line, strokeOpacity: 1 }),
      Plot.axisX({ label: "Points →", ticks: Math.max(2, Math.floor(frame.width / 110)), tickFormat: format.shortCount }),
      Plot.axisY({ label: null }),
      Plot.dot(shown, {
        ...place,
        r: 4,
        fill: ({ report }: TruePrimitive) => typeColour(typeName(report.type)),
        stroke: frame.soft,
        strokeWidth: 0.75,
        className: "primitives-dots",
        title: ({ model, report }: TruePrimitive) =>
          `${model}, ${typeName(report.type)} ${report.truth}: ${format.integer(report.size)} points, DSC ${format.measure("DSC", report.DSC)}`,
        ...leading(shown, visit),
      }),
      Plot.dot(current, { ...place, r: 7, stroke: frame.accent, strokeWidth: 2, pointerEvents: "none" }),
      ...keys.marks,
    ],
  });
}
