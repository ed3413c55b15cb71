// Every model in numbers.

import type { JSX } from "preact";
import { TYPES } from "../charts/surface-types";
import { goTo, HOME } from "../state/router";
import { selectModel } from "../state/selection";
import { count, words } from "../ui/columns";
import * as format from "../ui/format";
import { Table, type Column } from "../ui/table";
import type { DatasetStatistics } from "../engine/contract";
import type { CountedModel } from "./state";

type TypeName = keyof DatasetStatistics["types"];
const NAMES = TYPES as readonly TypeName[];

const columnsOf = (several: boolean): Column<CountedModel>[] => [
  words("model", "Model", ({ id }) => id),
  ...(several ? [words<CountedModel>("set", "Set", ({ set }) => set)] : []),
  count("points", "Points", ({ statistics }) => statistics.points),
  count("primitives", "Primitives", ({ statistics }) => statistics.primitives),
  ...NAMES.map((type) => count<CountedModel>(type, type, ({ statistics }) => statistics.types[type])),
  {
    id: "unsegmented",
    head: "Unsegmented",
    label: "share of points that no primitive lists",
    numeric: true,
    cell: ({ statistics }) => format.share(statistics.unsegmented ?? null),
    sortBy: ({ statistics }) => statistics.unsegmented,
    share: ({ statistics }) => statistics.unsegmented,
  },
  count("shared", "Shared", ({ statistics }) => statistics.shared, { label: "points that several primitives list" }),
];

interface Props {
  readonly models: readonly CountedModel[];
  readonly all: DatasetStatistics;
  readonly several: boolean;
}

export function ModelsTable({ models, all, several }: Props): JSX.Element {
  return (
    <Table
      caption="Models: a click shows one on the scoring page"
      columns={columnsOf(several)}
      rows={models}
      keyOf={({ id }) => id}
      onSelect={({ id }) => {
        selectModel(id);
        goTo(HOME);
      }}
      foot={
        <tr>
          <th scope="row">All {format.integer(all.models)}</th>
          {several && <td />}
          <td class="numeric">{format.integer(all.points)}</td>
          <td class="numeric">{format.integer(all.primitives)}</td>
          {NAMES.map((type) => (
            <td key={type} class="numeric">
              {format.integer(all.types[type])}
            </td>
          ))}
          <td class="numeric">{format.share(all.unsegmented)}</td>
          <td class="numeric">{format.integer(all.shared)}</td>
        </tr>
      }
    />
  );
}
