"""The formats of scores by the benchmark's measures: each makes one text of the results."""

from __future__ import annotations

import re
from typing import Any, Callable, Sequence

from .._declared import declared, names
from .figures import Value, align, figure, json_text, one_line, shown

Row = dict[str, Any]

_COUNTS = ("points", "truth", "predicted")
_FITTED = "†"
_NOTE = "came without surfaces: types, MFE, dHaus and distances of parameters are of those fitted here"
#: Whose a file is.
_OWNERS = (None, "truth", "method")
#: What LaTeX has no backslash for.
_SPECIAL = {"\\": "\\textbackslash{}", "~": "\\textasciitilde{}", "^": "\\textasciicircum{}"}


def csv_text(rows: Sequence[Sequence[Any]]) -> str:
    """Rows of cells as CSV (RFC 4180)."""
    return "".join(",".join(map(_cell, row)) + "\r\n" for row in rows)


def _cell(value: Any) -> str:
    text = value if isinstance(value, str) else "" if value is None else shown(value)
    return '"' + text.replace('"', '""') + '"' if re.search('[",\r\n]', text) else text


def guarded(text: str) -> str:
    """Spreadsheets run a text that starts like a formula; a leading apostrophe keeps it a text."""
    return f"'{text}" if re.match("[=+\\-@\t\r\n]", text) else text


def escaped_markdown(text: str) -> str:
    """Any character that Markdown or HTML gives a meaning, as itself."""
    return re.sub(r"[\\`*_{}\[\]()<>#+!|~&$@:]", lambda found: f"\\{found[0]}", one_line(text))


def escaped_latex(text: str) -> str:
    """Any character that LaTeX gives a meaning, as itself."""
    return re.sub(r"[\\~^#$%&_{}]", lambda found: _SPECIAL.get(found[0], f"\\{found[0]}"), one_line(text))


def each_once(lines: Sequence[str]) -> list[str]:
    """Without what stands there already."""
    return list(dict.fromkeys(lines))


def checksums(results: Sequence[Row]) -> list[str]:
    """Each file once, as ``sha256sum`` lists them."""
    return each_once([f"{file['sha256']}  {one_line(file['path'])}" for each in results for file in each["files"]])


def _provenance(results: Sequence[Row]) -> list[str]:
    ways = [f"Fit4CAD engine {one_line(each['engine'])}, protocol {each['protocol']}" for each in results]
    fitted = [one_line(each["method"]) for each in results if each.get("surfacesFitted")]
    notes = [f"Surfaces of {method} fitted by the engine to the segments given" for method in each_once(fitted)]
    return [*each_once(ways), *notes]


def _several(summaries: Sequence[Row]) -> list[Row]:
    """Those of which a mean says something."""
    return [each for each in summaries if each["models"] > 1]


def _means(summary: Row) -> list[Value]:
    return [summary["over"].get(key, {}).get("mean") for key in names("measures")]


def _json(results: Sequence[Row], _: Sequence[Row]) -> str:
    return json_text(results)


def _table(results: Sequence[Row], summaries: Sequence[Row]) -> str:
    if not results:
        return ""
    measures = names("measures")
    rows = [["model", "method", *_COUNTS, *measures, "type errors"]]
    for each in results:
        called = f"{each['method']} {_FITTED}" if each.get("surfacesFitted") else each["method"]
        counts = [str(each[key]) for key in _COUNTS]
        rows.append([each["model"], called, *counts, *(figure(each["mean"][key]) for key in measures), str(each["type_errors"])])
    for summary in _several(summaries):
        head = [f"mean of {summary['models']}", summary["method"], *("" for _ in _COUNTS)]
        rows.append([*head, *map(figure, _means(summary)), str(summary["typeErrors"])])
    note = f"{_FITTED} {_NOTE}\n" if any(each.get("surfacesFitted") for each in results) else ""
    return f"{align(rows, 2)}\n{note}"


def _csv(results: Sequence[Row], _: Sequence[Row]) -> str:
    files = [(owner, role) for owner in _OWNERS for role in names("roles") if (role == "cloud") == (owner is None)]
    head = ["model", "method", "protocol", *_COUNTS, *names("measures"), "type_errors", "engine"]
    head += ["_".join(filter(None, (owner, role, "sha256"))) for owner, role in files]

    def hashes(each: Row, role: str, submitted: bool) -> str:
        return " ".join(it["sha256"] for it in each["files"] if it["role"] == role and ("method" in it) == submitted)

    rows = [
        [
            *(guarded(each[key]) for key in ("model", "method", "protocol")),
            *(each[key] for key in _COUNTS),
            *(each["mean"][key] for key in names("measures")),
            *(each["type_errors"], guarded(each["engine"])),
            *(hashes(each, role, owner == "method") for owner, role in files),
        ]
        for each in results
    ]
    return csv_text([head, *rows])


def _markdown(results: Sequence[Row], summaries: Sequence[Row]) -> str:
    head = ["Model", "Method", "Points", "True", "Predicted", *names("measures"), "Type errors"]
    rows = [head, [*("---" for _ in range(2)), *("---:" for _ in head[2:])]]
    for each in results:
        called = [escaped_markdown(each["model"]), escaped_markdown(each["method"])]
        counts = [str(each[key]) for key in _COUNTS]
        rows.append([*called, *counts, *(figure(each["mean"][key]) for key in names("measures")), str(each["type_errors"])])
    for summary in _several(summaries):
        cells = [f"Mean of {summary['models']}", escaped_markdown(summary["method"]), *("" for _ in _COUNTS)]
        cells += [*map(figure, _means(summary)), str(summary["typeErrors"])]
        rows.append([cell and f"**{cell}**" for cell in cells])
    lines = [f"| {' | '.join(row)} |" for row in rows]
    ways = [f"{escaped_markdown(way)}." for way in _provenance(results)]
    return "\n".join([*lines, "", *ways, "", "```text", *checksums(results), "```"]) + "\n"


def _formula(term: Row) -> str:
    """A term in mathematical mode."""
    kind = term["kind"]
    if kind == "word":
        return f"\\text{{{escaped_latex(term['text'])}}}"
    if kind == "row":
        return " ".join(map(_formula, term["terms"]))
    if kind == "fraction":
        return f"\\frac{{{_formula(term['over'])}}}{{{_formula(term['under'])}}}"
    if kind == "sub":
        return f"{_formula(term['base'])}_{_grouped(_formula(term['index']))}"
    if kind == "under":
        return f"{_formula(term['operator'])}_{_grouped(_formula(term['range']))}"
    text: str = term["text"]
    return text


def _grouped(text: str) -> str:
    return text if len(text) == 1 else f"{{{text}}}"


def _latex(results: Sequence[Row], summaries: Sequence[Row]) -> str:
    def row(cells: Sequence[str]) -> str:
        return f"  {' & '.join(cells)} \\\\"

    def figures(values: Sequence[Value]) -> list[str]:
        return ["n/a" if value is None else f"${figure(value, 3)}$" for value in values]

    symbols = [each["symbol"] for each in declared()["measures"]]
    headings = [escaped_latex(it["text"]) if it["kind"] == "word" else f"${_formula(it)}$" for it in symbols]
    head = ["", "method", "\\# points", "\\# true", "\\# predicted", *headings]
    lines = [
        "% Needs \\usepackage{booktabs} and \\usepackage{amsmath}.",
        *(f"% {line}" for line in [*_provenance(results), *checksums(results)]),
        f"\\begin{{tabular}}{{ll{'r' * (len(head) - 2)}}}",
        "  \\toprule",
        row(head),
        "  \\midrule",
    ]
    before = None
    for each in results:
        # `PC 14`, as the paper writes it.
        spaced = "" if each["model"] == before else escaped_latex(re.sub(r"^PC(?=\d+$)", "PC ", each["model"]))
        before = each["model"]
        counts = [f"${each[key]:,}$".replace(",", "{,}") for key in _COUNTS]
        lines.append(row([spaced, escaped_latex(each["method"]), *counts, *figures([each["mean"][key] for key in names("measures")])]))
    means = [row([f"Mean of {it['models']}", escaped_latex(it["method"]), "", "", "", *figures(_means(it))]) for it in _several(summaries)]
    lines += [*(["  \\midrule"] if means else []), *means, "  \\bottomrule", "\\end{tabular}"]
    return "\n".join(lines) + "\n"


#: By the names that ``--format`` takes: what each is, and what writes it.
WRITERS: dict[str, tuple[str, Callable[[Sequence[Row], Sequence[Row]], str]]] = {
    "table": ("one aligned row per model and method", _table),
    "json": ("everything, down to each primitive and diagnostic", _json),
    "csv": ("one row per model and method, for a spreadsheet", _csv),
    "latex": ("a booktabs table like the paper's", _latex),
    "markdown": ("for a README or a discussion", _markdown),
}
