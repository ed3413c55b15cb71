// What is wrong with the ground truths, all models together.

import type { JSX } from "preact";
import { signal } from "@preact/signals";
import type { Severity } from "../engine/contract";
import { selectedModel, selectedPrimitive, selectModel } from "../state/selection";
import { words } from "../ui/columns";
import { plural } from "../ui/format";
import { Icon } from "../ui/icon";
import { Marked } from "../ui/marked";
import { Table, type Column, type Sorting } from "../ui/table";
import type { FoundIn } from "./state";
import { ofDiagonal } from "./share";

/** More would not be read, and would slow the page. */
const SHOWN_AT_MOST = 500;

const RANK: Readonly<Record<Severity, number>> = { error: 2, warning: 1, note: 0 };

const COLUMNS: readonly Column<FoundIn>[] = [
  words("model", "Model", ({ model }) => model),
  {
    id: "primitive",
    head: "Primitive",
    label: "primitive",
    numeric: true,
    cell: ({ primitive }) => primitive,
    sortBy: ({ primitive }) => primitive,
  },
  {
    id: "severity",
    head: "Severity",
    label: "severity",
    numeric: true,
    cell: ({ severity }) => (
      <span class={`mark ${severity}`}>
        <Icon name={severity === "note" ? "note" : "error"} />
        {severity}
      </span>
    ),
    sortBy: ({ severity }) => RANK[severity],
  },
  words("check", "Check", ({ check }) => check),
  {
    id: "value",
    head: "Measured",
    label: "what was measured",
    numeric: true,
    cell: ({ value }) => ofDiagonal(value),
    sortBy: ({ value }) => value,
    title: ({ limit }) => (limit === null ? undefined : `at most ${ofDiagonal(limit)} is right`),
  },
  {
    id: "finding",
    head: "Finding",
    label: "finding",
    cell: ({ message, hint }) => (
      <>
        <Marked text={message} />. <span class="hint">{hint && <Marked text={`${hint}.`} />}</span>
      </>
    ),
  },
];

const sorting = signal<Sorting | undefined>(undefined);

export function FindingsTable({ findings }: { findings: readonly FoundIn[] }): JSX.Element {
  return (
    <>
      <Table
        className="audit-findings"
        caption="Findings: a click shows the primitive in the view"
        columns={COLUMNS}
        rows={findings.slice(0, SHOWN_AT_MOST)}
        keyOf={({ key }) => key}
        sorting={sorting}
        isSelected={({ model, place }) =>
          model === selectedModel.value && selectedPrimitive.value?.side === "truth" && selectedPrimitive.value.index === place
        }
        onSelect={show}
      />
      {findings.length > SHOWN_AT_MOST && <p class="empty">… and {plural(findings.length - SHOWN_AT_MOST, "more")}.</p>}
    </>
  );
}

function show({ model, place }: FoundIn): void {
  selectModel(model);
  selectedPrimitive.value = place === undefined ? undefined : { side: "truth", index: place };
}
