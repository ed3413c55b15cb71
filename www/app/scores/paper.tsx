// The layout of the paper's tables: one row per model, the methods beside each other under each
// measure, the means at the foot.

import type { JSX } from "preact";
import { computed } from "@preact/signals";
import type { Measure, Report } from "../engine/contract";
import { ExplainButton } from "../measures/explain";
import { MEASURE, MEASURES } from "../measures/measures";
import { methods, scoredRows } from "../state/models";
import { selectedMethod, selectedModel, selectModel } from "../state/selection";
import { protocol } from "../state/settings";
import * as format from "../ui/format";
import { isWindowed, Seen, type Place } from "../ui/seen";
import { means } from "./means";
import { titleOf } from "./submissions";

interface ModelRow {
  readonly id: string;
  /** In the order of `methods`; nothing where the model has no such submission. */
  readonly reports: readonly (Report | undefined)[];
}

const rows = computed<readonly ModelRow[]>(() => {
  const byModel = new Map<string, Map<string, Report>>();
  for (const { entry, reports } of scoredRows.value) {
    const own = byModel.get(entry.id) ?? new Map<string, Report>();
    byModel.set(entry.id, own.set(reports.method, reports[protocol.value]));
  }
  return [...byModel].map(([id, own]) => ({ id, reports: methods.value.map((method) => own.get(method)) }));
});

export function PaperTable({ caption }: { caption: string }): JSX.Element {
  const columns = methods.value;
  return (
    <table class="paper" aria-rowcount={isWindowed(rows.value.length) ? rows.value.length + 2 : undefined}>
      <caption>{caption}</caption>
      <thead>
        <tr>
          <th scope="col" rowSpan={2}>
            Model
          </th>
          <th scope="col" rowSpan={2} class="numeric">
            Points
          </th>
          <th scope="col" rowSpan={2} class="numeric">
            True
          </th>
          <th scope="colgroup" colSpan={columns.length} class="group">
            Predicted
          </th>
          {MEASURES.map((measure) => (
            <th key={measure} scope="colgroup" colSpan={columns.length} class="group">
              <span class="head">
                {measure}
                <ExplainButton measure={measure} />
              </span>
            </th>
          ))}
        </tr>
        <tr>
          {["predicted", ...MEASURES].map((group) =>
            columns.map((method, at) => (
              <th key={`${group} ${method}`} scope="col" class={at === 0 ? "numeric group" : "numeric"}>
                {method}
              </th>
            )),
          )}
        </tr>
      </thead>
      <Seen
        as="tbody"
        items={rows.value}
        headRows={2}
        columns={3 + columns.length * (1 + MEASURES.length)}
        handle=".row-name"
        draw={(row, place) => <Row key={row.id} row={row} place={place} />}
      />
      {means.value && (
        <tfoot>
          <tr>
            <th scope="row" colSpan={3}>
              Mean
            </th>
            {columns.map((method, at) => (
              <td key={method} class={at === 0 ? "group" : undefined} />
            ))}
            {MEASURES.map((measure) =>
              columns.map((method, at) => {
                const own = means.value?.methods.find((candidate) => candidate.method === method);
                const spread = own?.over[measure];
                return (
                  <td
                    key={`${measure} ${method}`}
                    class={at === 0 ? "numeric group" : "numeric"}
                    title={titleOf(spread, own?.models ?? 0)}
                  >
                    {format.measure(measure, spread?.mean)}
                  </td>
                );
              }),
            )}
          </tr>
        </tfoot>
      )}
    </table>
  );
}

function Row({ row: { id, reports }, place }: { row: ModelRow; place: Place }): JSX.Element {
  const any = reports.find((report) => report !== undefined);
  const selected = id === selectedModel.value;
  const cellOf = (at: number, numeric = true) => ({
    class: `${numeric ? "numeric" : ""} ${at === 0 ? "group" : ""}`,
    onClick: () => selectModel(id, methods.value[at]),
    "data-selected": (selected && methods.value[at] === selectedMethod.value) || undefined,
  });
  return (
    <tr {...place} aria-current={selected ? "true" : undefined}>
      <th scope="row">
        <button type="button" class="row-name" onClick={() => selectModel(id)}>
          {id}
        </button>
      </th>
      <td class="numeric">{any && format.integer(any.points)}</td>
      <td class="numeric">{any?.truth}</td>
      {reports.map((report, at) => (
        <td key={at} {...cellOf(at)}>
          {report?.predicted ?? format.MISSING}
        </td>
      ))}
      {MEASURES.map((measure) => {
        const best = bestOf(measure, reports);
        return reports.map((report, at) => {
          const value = report?.mean[measure];
          const text = format.measure(measure, value);
          return (
            <td key={`${measure} ${at}`} {...cellOf(at)} title={value?.toString()}>
              {best !== undefined && value === best ? <strong>{text}</strong> : text}
            </td>
          );
        });
      })}
    </tr>
  );
}

/** The best value, where there are several to choose from. */
function bestOf(measure: Measure, reports: ModelRow["reports"]): number | undefined {
  const values = reports.flatMap((report) => report?.mean[measure] ?? []);
  if (values.length < 2) return undefined;
  return MEASURE[measure].better === "higher" ? Math.max(...values) : Math.min(...values);
}
