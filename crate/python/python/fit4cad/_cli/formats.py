"""The formats of scores by the benchmark's measures: each makes one text of the results."""

from __future__ import annotations

import re
from typing import Any, Callable, Optional, Sequence

from .._declared import declared, names
from .figures import Value, align, figure, json_text, one_line, shown
from .lines import LONG, Line, Wanted, lines_of, shortened

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
    ways = [
        f"{one_line(each['method'])}: the published result files, scored by protocol {each['protocol']}"
        if each.get("published")
        else f"Fit4CAD engine {one_line(each['engine'])}, protocol {each['protocol']}"
        for each in results
    ]
    fitted = [one_line(each["method"]) for each in results if each.get("surfacesFitted")]
    notes = [f"Surfaces of {method} fitted by the engine to the segments given" for method in each_once(fitted)]
    return [*each_once(ways), *notes]


def _json(results: Sequence[Row], _: Sequence[Row], __: Wanted) -> str:
    return json_text(results)


def _table(results: Sequence[Row], summaries: Sequence[Row], wanted: Wanted) -> str:
    if not results:
        return ""
    digits = 4 if wanted.digits is None else wanted.digits
    # Fixed, as the eye goes down a column.
    models, means = lines_of(results, summaries, wanted, lambda value: figure(value, digits))
    rows = [[*(["method", "models"] if wanted.means else ["model", "method", *_COUNTS]), *wanted.measures, "type errors"]]
    for at, line in enumerate([*models, *means]):
        if line.counts is not None:
            called = f"{line.method} {_FITTED}" if results[at].get("surfacesFitted") else line.method
            labels = [line.model, called, *map(_count, line.counts)]
        else:
            labels = [line.method, str(line.models)] if wanted.means else [f"mean of {line.models}", line.method, "", "", ""]
        rows.append([*labels, *(text for text, _ in line.figures), _count(line.type_errors)])
    fitted = not wanted.means and any(each.get("surfacesFitted") for each in results)
    note = f"{_FITTED} {_NOTE}\n" if fitted else ""
    return f"{align(rows, 1 if wanted.means else 2)}\n{note}"


def _count(value: Optional[int]) -> str:
    return "" if value is None else str(value)


def _csv(results: Sequence[Row], summaries: Sequence[Row], wanted: Wanted) -> str:
    digits = wanted.digits

    def write(value: Value) -> str:
        return "" if value is None else shown(value) if digits is None else shortened(value, digits)

    models, means = lines_of(results, summaries, wanted, write)
    if wanted.means:
        rows: list[list[Any]] = [["method", "protocol", "models", *wanted.measures, "type_errors", "engine"]]
        for line in means:
            own = next(each for each in results if each["method"] == line.method)
            figures = [text for text, _ in line.figures]
            rows.append([guarded(line.method), own["protocol"], line.models, *figures, line.type_errors, guarded(own["engine"])])
        return csv_text(rows)
    files = [(owner, role) for owner in _OWNERS for role in names("roles") if (role == "cloud") == (owner is None)]
    head = ["model", "method", "protocol", *_COUNTS, *wanted.measures, "type_errors", "engine"]
    head += ["_".join(filter(None, (owner, role, "sha256"))) for owner, role in files]

    def hashes(each: Row, role: str, submitted: bool) -> str:
        return " ".join(it["sha256"] for it in each["files"] if it["role"] == role and ("method" in it) == submitted)

    rows = [
        [
            *(guarded(each[key]) for key in ("model", "method", "protocol")),
            *(each[key] for key in _COUNTS),
            *(text for text, _ in line.figures),
            *(each["type_errors"], guarded(each["engine"])),
            *(hashes(each, role, owner == "method") for owner, role in files),
        ]
        for each, line in zip(results, models)
    ]
    return csv_text([head, *rows])


def _markdown(results: Sequence[Row], summaries: Sequence[Row], wanted: Wanted) -> str:
    digits = 4 if wanted.digits is None else wanted.digits
    models, means = lines_of(results, summaries, wanted, lambda value: shortened(value, digits))
    labels = ["Method"] if wanted.means else ["Model", "Method"]
    head = [*labels, *(["Models"] if wanted.means else ["Points", "True", "Predicted"]), *wanted.measures, "Type errors"]
    rows = [head, [*("---" for _ in labels), *("---:" for _ in head[len(labels) :])]]
    rows += [_markdown_cells(line, wanted) for line in [*models, *means]]
    lines = [f"| {' | '.join(row)} |" for row in rows]
    ways = [f"{escaped_markdown(way)}." for way in _provenance(results)]
    return "\n".join([*lines, "", *ways, "", "```text", *checksums(results), "```"]) + "\n"


def _markdown_cells(line: Line, wanted: Wanted) -> list[str]:
    """A line; below those of models that of a mean is bold as a whole, unless bold says which is best."""
    whole = line.counts is None and not wanted.means and not wanted.bold

    def strong(text: str, best: bool = False) -> str:
        return f"**{text}**" if text and (best or whole) else text

    called = escaped_markdown(line.method)
    if line.counts is not None:
        labels = [escaped_markdown(line.model), called, *map(_count, line.counts)]
    else:
        mean = [strong(f"Mean of {line.models}"), strong(called), "", "", ""]
        labels = [called, str(line.models)] if wanted.means else mean
    return [*labels, *(strong(text, best) for text, best in line.figures), strong(_count(line.type_errors))]


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


def _latex(results: Sequence[Row], summaries: Sequence[Row], wanted: Wanted) -> str:
    def row(cells: Sequence[str]) -> str:
        return f"  {' & '.join(cells)} \\\\"

    digits = 3 if wanted.digits is None else wanted.digits
    models, means = lines_of(results, summaries, wanted, lambda value: shortened(value, digits))
    symbols = [each["symbol"] for each in declared()["measures"] if each["key"] in wanted.measures]
    headings = [escaped_latex(it["text"]) if it["kind"] == "word" else f"${_formula(it)}$" for it in symbols]
    labels = ["method", "\\# models"] if wanted.means else ["", "method", "\\# points", "\\# true", "\\# predicted"]
    head = row([*labels, *headings])
    layout = ("lr" if wanted.means else "llrrr") + "r" * len(wanted.measures)
    body = []
    before = None
    for line in models:
        # `PC 14`, as the paper writes it.
        spaced = "" if line.model == before else escaped_latex(re.sub(r"^PC(?=\d+$)", "PC ", line.model))
        before = line.model
        counts = ["" if count is None else _whole(count) for count in line.counts or []]
        body.append(row([spaced, escaped_latex(line.method), *counts, *_latex_figures(line)]))
    body += ["  \\midrule"] if models and means else []
    for line in means:
        called = escaped_latex(line.method)
        labels = [called, _whole(line.models)] if wanted.means else [f"Mean of {line.models}", called, "", "", ""]
        body.append(row([*labels, *_latex_figures(line)]))
    long = len(models) + len(means) > LONG
    packages = [f"\\usepackage{{{name}}}" for name in ("booktabs", *(["longtable"] if long else []), "amsmath")]
    rules = ["  \\toprule", head, "  \\midrule"]
    if long:
        # Goes on over pages, its head on each.
        rows = [f"\\begin{{longtable}}{{{layout}}}", *rules, "  \\endhead", "  \\bottomrule", "  \\endfoot", *body, "\\end{longtable}"]
    else:
        rows = [f"\\begin{{tabular}}{{{layout}}}", *rules, *body, "  \\bottomrule", "\\end{tabular}"]
    lines = [
        f"% Needs {', '.join(packages[:-1])} and {packages[-1]}.",
        *(f"% {line}" for line in [*_provenance(results), *checksums(results)]),
        *rows,
    ]
    return "\n".join(lines) + "\n"


def _whole(value: int) -> str:
    return f"${value:,}$".replace(",", "{,}")


def _latex_figures(line: Line) -> list[str]:
    def written(text: str, best: bool) -> str:
        number = re.sub(r"e([+-])(\d+)$", lambda found: f"\\times10^{{{found[1].strip('+')}{found[2]}}}", text)
        return text if text == "n/a" else f"$\\mathbf{{{number}}}$" if best else f"${number}$"

    return [written(text, best) for text, best in line.figures]


#: By the names that ``--format`` takes: what each is, and what writes it.
WRITERS: dict[str, tuple[str, Callable[[Sequence[Row], Sequence[Row], Wanted], str]]] = {
    "table": ("one aligned row per model and method", _table),
    "json": ("everything, down to each primitive and diagnostic", _json),
    "csv": ("one row per model and method, for a spreadsheet", _csv),
    "latex": ("a booktabs table like the paper's", _latex),
    "markdown": ("for a README or a discussion", _markdown),
}

#: Those that are tables, and of these those that can make a figure stand out.
TABLES = ("table", "csv", "latex", "markdown")
BOLD = ("latex", "markdown")
