"""The lines of a table of results, before a format writes them: which there are, what they hold, which figure is best."""

from __future__ import annotations

import itertools
from dataclasses import dataclass
from typing import Any, Callable, Mapping, Optional, Sequence

from .._declared import declared, names
from .arguments import Option, UsageError, choice, named, number
from .figures import Value, fixed, scientific

Row = dict[str, Any]

#: From so many rows on a table takes more than a page.
LONG = 40
#: The most digits after the point: as many as tell any two figures of a submission apart.
_MOST_DIGITS = 12

OPTIONS = (
    Option("means", "the mean of each method alone, no rows of single models", None),
    Option("digits", "digits after the point; LaTeX and Markdown write what all of them would show as 0 as a power of ten"),
    Option("bold", "the best figure of each model, and the best mean, in bold: for latex and markdown", None),
    Option("published", "also the paper's two methods, scored from their published files by the same protocol, on its test models", None),
)


@dataclass(frozen=True)
class Wanted:
    """What a reader may want of a table of results."""

    means: bool
    """The methods' means alone."""
    measures: Sequence[str]
    """The columns."""
    digits: Optional[int]
    """After the point; where nothing is said each format has its own number."""
    bold: bool
    """Whether the best of several values is bold."""


@dataclass(frozen=True)
class Line:
    """A method on a model, or its mean over several."""

    model: str
    models: int
    method: str
    counts: Optional[Sequence[Optional[int]]]
    """Points, true and predicted primitives of one model."""
    figures: Sequence[tuple[str, bool]]
    """In the order of the measures wanted: as written, and whether it is to stand out."""
    type_errors: Optional[int]
    """``None`` where it is not known."""


def are_columns(values: Mapping[str, Any]) -> bool:
    """Whether ``--measures`` names measures of the benchmark, by its own protocols: columns of its table, no figures of fit."""
    measures, own = values["measures"], values["protocol"] in names("protocols") and values["by"] is None
    return own and measures is not None and any(name.strip() in names("measures") for name in measures.split(","))


def wanted_of(values: Mapping[str, Any], form: str, tables: Sequence[str], bold: Sequence[str]) -> Wanted:
    """What is wanted of a table in a format, of those that are tables and those that have bold figures."""
    columns = names("measures") if values["measures"] is None else named("measures", values["measures"], names("measures"))
    digits = number("digits", values["digits"], least=0, most=_MOST_DIGITS, whole=True)
    given = _given(values)
    if form not in tables and given:
        raise UsageError(f"{', '.join(given)}: for tables; --format {form} has everything")
    if values["bold"] and form not in bold:
        raise UsageError(f"--bold: for --format {' or '.join(bold)}; {form} has no bold figures")
    measures = [measure for measure in names("measures") if measure in columns]
    return Wanted(values["means"], measures, None if digits is None else int(digits), values["bold"])


def refuse_beside_field(values: Mapping[str, Any]) -> None:
    """Refuses what is for the benchmark's own table where the field's are asked for."""
    given = _given({**values, "measures": None})
    if given:
        raise UsageError(f"{', '.join(given)}: for the benchmark's own measures, not for other protocols, figures of fit or strata")


def _given(values: Mapping[str, Any]) -> list[str]:
    return [f"--{name}" for name in ("measures", *(option.name for option in OPTIONS)) if values[name] not in (None, False)]


def lines_of(
    results: Sequence[Row], summaries: Sequence[Row], wanted: Wanted, write: Callable[[Value], str]
) -> tuple[list[Line], list[Line]]:
    """The lines of single models, none where means alone are wanted, and those of the means: of every method where they
    stand alone, else of those with several models."""
    published = {each["method"] for each in results if each.get("published")}
    of = [each for each in summaries if wanted.means or each["models"] > 1]
    means = _cells([[each["over"].get(key, {}).get("mean") for key in wanted.measures] for each in of], wanted, write)
    lines = []
    for model, group in itertools.groupby([] if wanted.means else results, key=lambda each: each["model"]):
        block = list(group)
        for each, figures in zip(block, _cells([[it["mean"].get(key) for key in wanted.measures] for it in block], wanted, write)):
            counts = [each[key] for key in ("points", "truth", "predicted")]
            lines.append(Line(model, 1, each["method"], counts, figures, each["type_errors"]))
    feet = [
        Line("", each["models"], each["method"], None, figures, None if each["method"] in published else each["typeErrors"])
        for each, figures in zip(of, means)
    ]
    return lines, feet


def _cells(rows: Sequence[Sequence[Value]], wanted: Wanted, write: Callable[[Value], str]) -> list[list[tuple[str, bool]]]:
    """The figures of rows, the best of each column marked where there are several. Those that read alike are alike."""
    texts = [[write(value) for value in row] for row in rows]
    best: list[Optional[float]] = [None for _ in wanted.measures]
    if wanted.bold:
        better = {each["key"]: max if each["better"] == "higher" else min for each in declared()["measures"]}
        for column, measure in enumerate(wanted.measures):
            values = [float(text[column]) for text, row in zip(texts, rows) if row[column] is not None]
            best[column] = better[measure](values) if len(values) > 1 else None
    return [
        [(text, value is not None and at is not None and float(text) == at) for text, value, at in zip(own, row, best)]
        for own, row in zip(texts, rows)
    ]


def shortened(value: Value, digits: int) -> str:
    """With so many digits after the point; as a power of ten where those would all be noughts and the value is none."""
    if value is None:
        return "n/a"
    text = fixed(value, digits)
    return scientific(value, 1) if value and not float(text) else text
