"""Tables of figures with heads of their own, in the text formats."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Callable, Sequence

from .figures import Value, align, fixed, one_line, scientific
from .formats import csv_text, escaped_latex, escaped_markdown, guarded


@dataclass(frozen=True)
class Column:
    """A column of figures."""

    title: str
    decimals: int
    scientific: bool = False

    def text(self, value: Value) -> str:
        """A figure of it."""
        if value is None:
            return "n/a"
        return scientific(value, self.decimals) if self.scientific else fixed(value, self.decimals)


@dataclass(frozen=True)
class Sheet:
    """A table: rows of labels, then of figures."""

    caption: str
    heads: Sequence[str]
    columns: Sequence[Column]
    rows: Sequence[tuple[Sequence[str], Sequence[Value]]]

    def titles(self) -> list[str]:
        """What stands above its columns."""
        return [*self.heads, *(column.title for column in self.columns)]

    def cells(self, values: Sequence[Value]) -> list[str]:
        """The figures of a row as they are shown."""
        return [column.text(value) for column, value in zip(self.columns, values)]


@dataclass(frozen=True)
class Sheets:
    """Tables, and what is to be said with them: where the figures come from."""

    sheets: Sequence[Sheet] = field(default_factory=list)
    notes: Sequence[str] = field(default_factory=list)


def _table(all_of: Sheets) -> str:
    texts = []
    for sheet in all_of.sheets:
        rows = [sheet.titles(), *([*labels, *sheet.cells(values)] for labels, values in sheet.rows)]
        caption = f"{sheet.caption}\n" if len(all_of.sheets) > 1 else ""
        texts.append(f"{caption}{align(rows, len(sheet.heads))}\n")
    return "\n".join(texts)


def _csv(all_of: Sheets) -> str:
    note = guarded(all_of.notes[0] if all_of.notes else "")
    texts = [
        csv_text(
            [
                ["table", *sheet.titles(), "provenance"],
                *([*map(guarded, (sheet.caption, *labels)), *values, note] for labels, values in sheet.rows),
            ]
        )
        for sheet in all_of.sheets
    ]
    return "\r\n".join(texts)


def _markdown(all_of: Sheets) -> str:
    lines: list[str] = []
    for sheet in all_of.sheets:
        if len(all_of.sheets) > 1:
            lines += [f"**{escaped_markdown(sheet.caption)}**", ""]
        rows = [
            [*sheet.heads, *(escaped_markdown(column.title) for column in sheet.columns)],
            [*("---" for _ in sheet.heads), *("---:" for _ in sheet.columns)],
            *([*map(escaped_markdown, labels), *sheet.cells(values)] for labels, values in sheet.rows),
        ]
        lines += [*(f"| {' | '.join(row)} |" for row in rows), ""]
    return "\n".join([*lines, "```text", *map(one_line, all_of.notes), "```"]) + "\n"


def _latex(all_of: Sheets) -> str:
    def row(cells: Sequence[str]) -> str:
        return f"  {' & '.join(cells)} \\\\"

    lines = ["% Needs \\usepackage{booktabs}.", *(f"% {one_line(note)}" for note in all_of.notes)]
    for sheet in all_of.sheets:
        lines += [
            f"% {one_line(sheet.caption)}",
            f"\\begin{{tabular}}{{{'l' * len(sheet.heads)}{'r' * len(sheet.columns)}}}",
            "  \\toprule",
            row([escaped_latex(title) for title in sheet.titles()]),
            "  \\midrule",
        ]
        for labels, values in sheet.rows:
            cells = ["n/a" if value is None else f"${column.text(value)}$" for column, value in zip(sheet.columns, values)]
            lines.append(row([*map(escaped_latex, labels), *cells]))
        lines += ["  \\bottomrule", "\\end{tabular}"]
    return "\n".join(lines) + "\n"


#: By the names that ``--format`` takes; JSON is no table.
SHEET_WRITERS: dict[str, Callable[[Sheets], str]] = {"table": _table, "csv": _csv, "latex": _latex, "markdown": _markdown}
