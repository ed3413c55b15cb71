"""What the field reports, summed up: over models, method against method, and by strata of primitives. What is computed
is asked of the engine; here it is only said of what."""

from __future__ import annotations

import math
from typing import Any, Iterable, Optional, Sequence

from .. import _engine
from .._declared import declared
from .figures import Value, fixed

Row = dict[str, Any]

#: Stands for all strata together.
ALL_SEGMENTS = "all"


def by_method(results: Sequence[Row]) -> dict[str, list[Row]]:
    """The methods in the order in which they first appear, each with its reports."""
    methods: dict[str, list[Row]] = {}
    for result in results:
        methods.setdefault(result["method"], []).append(result)
    return methods


def _numbers(values: Iterable[Value]) -> list[float]:
    return [math.nan if value is None else float(value) for value in values]


def _spread(values: Iterable[Value]) -> Optional[Row]:
    return _engine.distribution(_numbers(values))


def _figures(results: Sequence[Row], key: str) -> list[float]:
    return _numbers(result["figures"][key] for result in results)


def spreads_of(results: Sequence[Row], figures: Sequence[Row]) -> list[Row]:
    """Over several models: the spread of each figure, method by method."""
    return [
        {
            "method": method,
            "models": len(own),
            "figures": [{"figure": it["key"], "spread": _spread(_figures(own, it["key"]))} for it in figures],
        }
        for method, own in by_method(results).items()
    ]


def comparisons_of(results: Sequence[Row], figures: Sequence[Row]) -> list[Row]:
    """Each method against each that comes after it, over the models that both have."""
    methods = list(by_method(results).items())
    rows = []
    for at, (one, own) in enumerate(methods):
        for other, theirs in methods[at + 1 :]:
            partners = {result["model"]: result for result in theirs}
            pairs = [(result, partners[result["model"]]) for result in own if result["model"] in partners]
            left, right = [pair[0] for pair in pairs], [pair[1] for pair in pairs]
            for it in figures:
                found = _engine.compare_figures(_figures(left, it["key"]), _figures(right, it["key"]), it["better"] == "higher")
                rows.append({"figure": it["key"], "title": it["title"], "method": one, "against": other, **found})
    return rows


def _strata_in(report: Row, by: Row) -> list[str]:
    """The stratum of each true primitive of a report, in their order."""
    name = by["name"]
    if name == "size":
        return [each["stratum"] for each in report["primitives"]]
    if name == "type":
        return [each["type"] or declared()["otherType"] for each in report["primitives"]]
    own = [each["stratum"] for each in report.get("conditions", []) if each["by"] == name]
    return [own[0] if own else by["strata"][-1]] * len(report["primitives"])


def strata_of(results: Sequence[Row], by: Row) -> list[Row]:
    """True primitives by stratum: how many of how many models, how well they coincide with their partner, and how
    many are hits."""
    rows = []
    for method, own in by_method(results).items():
        inside: dict[str, list[tuple[str, float]]] = {}
        for report in own:
            for stratum, each in zip(_strata_in(report, by), report["primitives"]):
                inside.setdefault(stratum, []).append((report["model"], each["iou"]))
        for stratum in filter(inside.get, by["strata"]):
            models, ious = zip(*inside[stratum])
            hits = _spread([1.0 if iou > 0.5 else 0.0 for iou in ious])
            counts = {"models": len(set(models)), "primitives": len(ious)}
            found = {"iou": _spread(ious), "found": None if hits is None else hits["mean"]}
            rows.append({"method": method, "stratum": stratum, **counts, **found})
    return rows


def spreads_by_condition(results: Sequence[Row], by: Row, figures: Sequence[Row]) -> list[Row]:
    """The figures of the models of each stratum, method by method: for what is a condition of a model."""
    rows: list[Row] = []
    for stratum in by["strata"] if by["isCondition"] else []:
        wanted = (by["name"], stratum)
        inside = [it for it in results if any((each["by"], each["stratum"]) == wanted for each in it.get("conditions", []))]
        rows += [{"stratum": stratum, **spread} for spread in spreads_of(inside, figures)]
    return rows


def recognition_of(results: Sequence[Row], by: Optional[Row] = None) -> list[Row]:
    """SHREC 2022's tables: how well the types of segments are told, and how well they are fitted; of all, and by
    stratum where one is asked for."""
    rows = []
    for method, own in by_method(results).items():
        inside: dict[str, list[Row]] = {}
        for report in own:
            segments = report.get("segments", [])
            strata = [ALL_SEGMENTS] * len(segments) if by is None else _strata_in(report, by)
            for stratum, segment in zip(strata, segments):
                inside.setdefault(stratum, []).append(segment)
        for stratum in filter(inside.get, [ALL_SEGMENTS] if by is None else by["strata"]):
            segments = inside[stratum]
            rows.append(
                {
                    "method": method,
                    "stratum": stratum,
                    "segments": len(segments),
                    "rates": _engine.rates([(each["type"], each["answer"]) for each in segments]),
                    **{key: _spread(each[key] for each in segments) for key in ("mfe", "hausdorff", "parameters")},
                }
            )
    return rows


def ranks_of(spreads: Sequence[Row], figure: Row) -> dict[str, int]:
    """The place of each method by a figure, from 1, those equal to the digits shown sharing one; absent for those
    without the figure."""
    means = {}
    for each in spreads:
        for it in each["figures"]:
            if it["figure"] == figure["key"] and it["spread"] is not None:
                means[each["method"]] = float(fixed(it["spread"]["mean"], figure["decimals"]))
    sign = 1 if figure["better"] == "higher" else -1
    return {method: 1 + sum(sign * each > sign * mean for each in means.values()) for method, mean in means.items()}
