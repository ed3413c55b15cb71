"""``fit4cad stats``."""

from __future__ import annotations

import math
from typing import Any, Sequence

from .. import _engine
from .._declared import declared, names
from .._errors import Diagnostic
from .._files import Group
from .arguments import FORMATS, format_of, read_arguments, some
from .figures import align, json_text, share, shown
from .formats import csv_text, guarded
from .models import Hear, each_model, found, of_truth
from .terminal import clear, print_text, tell, warn

Row = dict[str, Any]

USAGE = "PATH… [--format table|json|csv]"
WORDS = "Counts the models found in the given files, folders and zips: points, true primitives by type, and the share of points that no primitive lists."
OPTIONS = FORMATS

#: Length of a bar that stands for all primitives.
_BAR = 50


def stats(args: Sequence[str]) -> int:
    """Counts what the models named by the arguments hold; gives the exit code."""
    values, paths = read_arguments(args, OPTIONS)
    some(paths)
    form = format_of(values, ["table", "json", "csv"])

    def visit(group: Group, _: Hear) -> tuple[Any, list[Diagnostic]]:
        model = group.read(of_truth)
        truth = None if model.truth is None else model.truth._native
        counted = _engine.statistics_of(model.name, model._cloud, truth)
        return counted, [each for each in model.diagnostics if each.severity == "error"]

    files, problems = found(paths)
    visited, unplaced, stops = each_model(files, visit, "counting")
    clear()
    failed = tell([*problems, *(problem for _, told in visited for problem in told), *unplaced, *stops])
    if not visited:
        warn("fit4cad stats: there is no model among the files; see fit4cad stats --help.")
    counted = [each for each, _ in visited]
    models, of_set = [each.to_dict() for each in counted], _engine.statistics(counted)
    for key in ("pointsPerModel", "primitivesPerModel", "unsegmentedPerModel"):
        spread = of_set[key]
        of_set[key] = None if spread is None else {name: spread[name] for name in ("min", "median", "max")}
    if form == "json":
        print_text(json_text({"engine": _engine.__version__, "set": of_set, "models": models}))
    else:
        print_text(_csv(models) if form == "csv" else _table(of_set, models))
    return 1 if failed or not visited else 0


def _types() -> list[str]:
    return [*names("surfaceTypes"), declared()["otherType"]]


def _csv(models: Sequence[Row]) -> str:
    rows: list[list[Any]] = [["model", "points", "primitives", *map(str.lower, _types()), "unsegmented", "shared", "engine"]]
    for each in models:
        counts = [each["points"], each["primitives"], *(each["types"][name] for name in _types())]
        rows.append([guarded(each["name"]), *counts, each.get("unsegmented"), each["shared"], guarded(_engine.__version__)])
    return csv_text(rows)


def _table(of_set: Row, models: Sequence[Row]) -> str:
    if not models:
        return ""

    def row(name: str, counted: Row) -> list[str]:
        counts = [counted["points"], counted["primitives"], *(counted["types"][each] for each in _types())]
        return [name, *map(shown, counts), share(counted.get("unsegmented"))]

    head = ["model", "points", "primitives", *_types(), "unsegmented"]
    rows = [row(each["name"], each) for each in models]
    blocks = [align([head, *rows, row(f"all {of_set['models']}", of_set)], 1)]
    if len(models) > 1:
        blocks.append(align(_spreads(of_set), 1))
    if of_set["primitives"] > 0:
        blocks.append(align(_bars(of_set), 1))
    return "\n\n".join(blocks) + "\n"


def _spreads(of_set: Row) -> list[list[str]]:
    rows = [["per model", "least", "median", "most"]]
    for name, show in (("points", shown), ("primitives", shown), ("unsegmented", share)):
        spread = of_set[f"{name}PerModel"]
        cells = ["n/a"] * 3 if spread is None else [show(spread[key]) for key in ("min", "median", "max")]
        rows.append([name, *cells])
    return rows


def _bars(of_set: Row) -> list[list[str]]:
    """The paper's bar chart of surface types."""
    rows = []
    for name in _types():
        count, part = of_set["types"][name], (of_set["typeShares"] or {}).get(name, 0)
        if count or name != declared()["otherType"]:
            rows.append([name, str(count), share(part), ("█" * math.floor(part * _BAR + 0.5)).ljust(_BAR)])
    return rows
