// A sortable table that is a table: caption, column and row heads, sort buttons, keyboard.

import type { ComponentChildren, JSX } from "preact";
import { useSignal, type Signal } from "@preact/signals";
import { isWindowed, Seen } from "./seen";

export interface Column<Row> {
  readonly id: string;
  readonly head: ComponentChildren;
  /** Set beside the head, outside the sort button (an explanation, say). */
  readonly aside?: ComponentChildren;
  /** The head in words, for sort buttons. */
  readonly label: string;
  readonly cell: (row: Row) => ComponentChildren;
  /** The value to sort by; without it the column does not sort. Missing values come last either way. */
  readonly sortBy?: (row: Row) => number | string | null | undefined;
  readonly numeric?: boolean;
  /** The value as a share of 1, drawn as a faint bar behind the figure. */
  readonly share?: (row: Row) => number | null | undefined;
  /** How strongly the cell is shaded, a share of 1, and in which sense. */
  readonly heat?: (row: Row) => { readonly outcome: "better" | "worse"; readonly share: number } | undefined;
  readonly title?: (row: Row) => string | undefined;
}

export interface Sorting {
  readonly column: string;
  readonly descending: boolean;
}

interface Props<Row> {
  readonly caption: ComponentChildren;
  /** The first column names its row. */
  readonly columns: readonly Column<Row>[];
  readonly rows: readonly Row[];
  readonly keyOf: (row: Row) => string;
  readonly isSelected?: (row: Row) => boolean;
  readonly isHovered?: (row: Row) => boolean;
  readonly onSelect?: (row: Row) => void;
  readonly onHover?: (row: Row | undefined) => void;
  readonly sorting?: Signal<Sorting | undefined>;
  readonly foot?: ComponentChildren;
  readonly className?: string;
}

export function Table<Row>(props: Props<Row>): JSX.Element {
  const own = useSignal<Sorting | undefined>(undefined);
  const sorting = props.sorting ?? own;
  const rows = sorted(props.rows, props.columns, sorting.value);

  const turn = (column: Column<Row>) => {
    const current = sorting.value;
    // Figures are first wanted largest first, names in order of the alphabet.
    const first = column.numeric ?? false;
    if (current?.column !== column.id) sorting.value = { column: column.id, descending: first };
    else if (current.descending === first) sorting.value = { column: column.id, descending: !first };
    else sorting.value = undefined;
  };

  return (
    <table class={props.className} aria-rowcount={isWindowed(rows.length) ? rows.length + 1 : undefined}>
      <caption>{props.caption}</caption>
      <thead>
        <tr>
          {props.columns.map((column) => (
            <Head key={column.id} column={column} sorting={sorting.value} onSort={() => turn(column)} />
          ))}
        </tr>
      </thead>
      <Seen
        as="tbody"
        items={rows}
        columns={props.columns.length}
        handle=".row-name"
        onMouseLeave={props.onHover && (() => props.onHover?.(undefined))}
        draw={(row, place) => (
          <tr
            key={props.keyOf(row)}
            {...place}
            aria-current={props.isSelected?.(row) ? "true" : undefined}
            data-hovered={props.isHovered?.(row) || undefined}
            onClick={props.onSelect && (() => props.onSelect?.(row))}
            onMouseEnter={props.onHover && (() => props.onHover?.(row))}
          >
            {props.columns.map((column, i) => cell(column, row, i === 0, props.onSelect !== undefined))}
          </tr>
        )}
      />
      {props.foot && <tfoot>{props.foot}</tfoot>}
    </table>
  );
}

function Head<Row>({ column, sorting, onSort }: { column: Column<Row>; sorting: Sorting | undefined; onSort: () => void }) {
  const active = sorting?.column === column.id;
  const direction = active ? (sorting.descending ? "descending" : "ascending") : undefined;
  return (
    <th scope="col" aria-sort={direction} class={column.numeric ? "numeric" : undefined}>
      <span class="head">
        {column.sortBy ? (
          <button type="button" class="sort" onClick={onSort} title={`Sort by ${column.label}`}>
            {column.head}
            <span class="arrow" aria-hidden="true">
              {active ? (sorting.descending ? "↓" : "↑") : ""}
            </span>
          </button>
        ) : (
          column.head
        )}
        {column.aside}
      </span>
    </th>
  );
}

function cell<Row>(column: Column<Row>, row: Row, names: boolean, selectable: boolean): JSX.Element {
  const content = column.cell(row);
  if (names) {
    return (
      <th key={column.id} scope="row" title={column.title?.(row)}>
        {selectable ? (
          <button type="button" class="row-name">
            {content}
          </button>
        ) : (
          content
        )}
      </th>
    );
  }
  const share = column.share?.(row);
  const bar = share === null || share === undefined ? undefined : { "--share": Math.min(1, Math.max(0, share)) };
  const heat = column.heat?.(row);
  return (
    <td
      key={column.id}
      class={`${column.numeric ? "numeric" : ""} ${bar ? "meter" : ""}`}
      data-heat={heat?.outcome}
      style={heat ? { ...bar, "--heat": heat.share } : bar}
      title={column.title?.(row)}
    >
      {content}
    </td>
  );
}

/** The rows as a table has them that is sorted so. */
export function sorted<Row>(rows: readonly Row[], columns: readonly Column<Row>[], sorting: Sorting | undefined): readonly Row[] {
  const by = columns.find(({ id }) => id === sorting?.column)?.sortBy;
  if (!sorting || !by) return rows;
  const sign = sorting.descending ? -1 : 1;
  return rows
    .map((row) => ({ row, value: by(row) ?? undefined }))
    .sort((a, b) => {
      if (a.value === undefined || b.value === undefined) return Number(a.value === undefined) - Number(b.value === undefined);
      if (typeof a.value === "number" && typeof b.value === "number") return sign * (a.value - b.value);
      return sign * String(a.value).localeCompare(String(b.value), "en", { numeric: true });
    })
    .map(({ row }) => row);
}
