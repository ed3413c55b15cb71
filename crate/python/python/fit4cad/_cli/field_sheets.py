"""What the field reports as tables: per model and method, over models, against each other, by strata of primitives, and
segment by segment as SHREC 2022 has it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Optional, Sequence

from .._declared import declared
from .field_sums import comparisons_of, ranks_of, recognition_of, spreads_by_condition, spreads_of, strata_of
from .figures import Value, one_line, shown
from .formats import checksums, each_once
from .sheet import Column, Sheet, Sheets

if TYPE_CHECKING:
    from .field import Field

Row = dict[str, Any]

#: The rates of SHREC 2022, in the order of its tables.
_RATES = ("PPV", "NPV", "TPR", "TNR", "ACC")


def field_sheets(results: Sequence[Row], field: Field) -> Sheets:
    """The tables, with what is to be said of them."""
    if not results:
        return Sheets()
    spreads = spreads_of(results, field.figures)
    sheets: list[Sheet] = []
    if field.figures:
        sheets += [_figures(results, spreads, field), *_places(spreads, field), *_pairs(results, field)]
    for by in field.by:
        sheets += _strata(results, by, field)
    if field.segments:
        for each in [None, *field.by]:
            sheets += _segments(results, field, each)
    scale = f"lengths normalised by {field.normalisation}, epsilon {shown(field.epsilon)}"
    versions = each_once([each["engine"] for each in results])
    notes = [f"Fit4CAD engine {one_line(version)}, {scale}" for version in versions]
    notes += [f"{by['title']}: {by['how']}" for by in field.by]
    return Sheets(sheets, [*notes, *checksums(results)])


def _unit(field: Field) -> str:
    """What a length is given in, in words."""
    units: list[str] = [each["unit"] for each in declared()["normalisations"] if each["name"] == field.normalisation]
    return units[0]


def _columns(field: Field) -> list[Column]:
    return [Column(_head(figure, field), figure["decimals"]) for figure in field.figures]


def _head(figure: Row, field: Field) -> str:
    """Head of a figure's column, with its unit and, of lengths, what they are divided by."""
    unit = figure["unit"]
    if figure["isNormalised"]:
        length = _unit(field)
        # Of what is better the higher, a coverage, ε is the length.
        unit = length if figure["better"] == "lower" else f"ε = {shown(field.epsilon)} {length}"
    return f"{figure['title']} ({unit})" if unit else figure["title"]


def _of(spread: Optional[Row], key: str) -> Value:
    return None if spread is None else spread[key]


def _interval(spread: Optional[Row], end: int) -> Value:
    return None if spread is None or spread["interval"] is None else spread["interval"][end]


def _figures(results: Sequence[Row], spreads: Sequence[Row], field: Field) -> Sheet:
    """Every model and method, then each method over its models."""
    keys = [figure["key"] for figure in field.figures]
    rows: list[tuple[list[str], list[Value]]] = [
        ([each["model"], each["method"]], [each["figures"][key] for key in keys]) for each in results
    ]
    for each in spreads:
        if each["models"] > 1:
            own = [it["spread"] for it in each["figures"]]
            for name, values in (
                (f"mean of {each['models']}", [_of(it, "mean") for it in own]),
                ("95 % interval from", [_interval(it, 0) for it in own]),
                ("95 % interval to", [_interval(it, 1) for it in own]),
                ("lower quartile", [_of(it, "lowerQuartile") for it in own]),
                ("median", [_of(it, "median") for it in own]),
                ("upper quartile", [_of(it, "upperQuartile") for it in own]),
            ):
                rows.append(([name, each["method"]], values))
    return Sheet("figures", ["model", "method"], _columns(field), rows)


def _places(spreads: Sequence[Row], field: Field) -> list[Sheet]:
    """The place of each method by each protocol, and by how much it is another than by the first."""
    protocols = [figure for figure in field.figures if figure["group"] == "segmentation"]
    if len(spreads) < 2 or len(protocols) < 2:
        return []
    ranks = [ranks_of(spreads, figure) for figure in protocols]

    def text(place: Optional[int], first: Optional[int]) -> str:
        if place is None or first is None or place == first:
            return "n/a" if place is None else str(place)
        return f"{place} (up {first - place})" if place < first else f"{place} (down {place - first})"

    rows: list[tuple[list[str], list[Value]]] = [
        ([each["method"], *(text(rank.get(each["method"]), ranks[0].get(each["method"])) for rank in ranks)], [])
        for each in spreads
    ]
    caption = "places of the methods, by the mean over their models; moved against the first protocol"
    return [Sheet(caption, ["method", *(figure["title"] for figure in protocols)], [], rows)]


def _pairs(results: Sequence[Row], field: Field) -> list[Sheet]:
    pairs = [it for it in comparisons_of(results, field.figures) if it["better"] + it["even"] + it["worse"] > 1]
    if not pairs:
        return []
    columns = [Column("mean difference", 5), *(Column(title, 0) for title in ("wins", "ties", "losses")), Column("p (Wilcoxon)", 4)]
    rows = [
        (
            [it["title"], it["method"], it["against"]],
            [_of(it["mean"], "by"), it["better"], it["even"], it["worse"], _of(it["test"], "probability")],
        )
        for it in pairs
    ]
    return [Sheet("methods against each other, model by model", ["figure", "method", "against"], columns, rows)]


def _strata(results: Sequence[Row], by: Row, field: Field) -> list[Sheet]:
    """True primitives by stratum; of what is a condition of models also the figures of these."""
    shares = ("mean IoU", "95 % from", "95 % to", "lower quartile", "median IoU", "upper quartile", "share with IoU > 0.5")
    columns = [*(Column(title, 0) for title in ("models", "primitives")), *(Column(title, 4) for title in shares)]
    rows = []
    for it in strata_of(results, by):
        iou = it["iou"]
        quartiles = [_of(iou, key) for key in ("lowerQuartile", "median", "upperQuartile")]
        spread = [_of(iou, "mean"), _interval(iou, 0), _interval(iou, 1), *quartiles]
        rows.append(([it["stratum"], it["method"]], [it["models"], it["primitives"], *spread, it["found"]]))
    heads = [by["name"], "method"]
    sheets = [Sheet(f"true primitives by {by['name']}", heads, columns, rows)]
    conditioned = spreads_by_condition(results, by, field.figures)
    if conditioned:
        own = [([it["stratum"], it["method"]], [it["models"], *(_of(each["spread"], "mean") for each in it["figures"])]) for it in conditioned]
        sheets.append(Sheet(f"figures by {by['name']}, mean over models", heads, [Column("models", 0), *_columns(field)], own))
    return sheets


def _segments(results: Sequence[Row], field: Field, by: Optional[Row]) -> list[Sheet]:
    """SHREC 2022's tables, of all segments or by stratum."""
    title, of = declared()["recognition"]["title"], "segments" if by is None else f"segments by {by['name']}"
    heads = ["segments" if by is None else by["name"], "method"]
    count, length = Column("count", 0), _unit(field)
    measured = (
        ("mfe", f"MFE ({length})"),
        ("hausdorff", f"directed Hausdorff ({length})"),
        ("parameters", "L2 of parameters (mixed units)"),
    )
    fitted = (("mean", "mean"), ("lower quartile", "lowerQuartile"), ("median", "median"), ("upper quartile", "upperQuartile"))
    rows = recognition_of(results, by)
    types = [([it["stratum"], it["method"]], [it["segments"], *(it["rates"][rate] for rate in _RATES)]) for it in rows]
    fits = [
        ([it["stratum"], it["method"], head], [_of(it[key], "count") or 0, *(_of(it[key], value) for _, value in fitted)])
        for it in rows
        for key, head in measured
    ]
    return [
        Sheet(f"{title}, types of {of}: mean over types", heads, [count, *(Column(rate, 4) for rate in _RATES)], types),
        Sheet(f"{title}, fit of {of}", [*heads, "measure"], [count, *(Column(name, 2, True) for name, _ in fitted)], fits),
    ]
