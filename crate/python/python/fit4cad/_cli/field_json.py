"""What the field reports as JSON: every figure with protocol, normalisation and engine version."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Sequence

from .._declared import declared
from .field_sums import comparisons_of, ranks_of, recognition_of, spreads_by_condition, spreads_of, strata_of
from .figures import json_text

if TYPE_CHECKING:
    from .field import Field

Row = dict[str, Any]


def field_json(results: Sequence[Row], field: Field) -> str:
    """The text."""
    version = results[0]["engine"] if results else ""

    def way(figure: Row) -> Row:
        scaled = figure["isNormalised"]
        return {
            "figure": figure["key"],
            "protocol": figure["title"] if figure["group"] == "segmentation" else "SPFN matching",
            "normalisation": field.normalisation if scaled else None,
            **({"epsilon": field.epsilon} if scaled else {}),
            "engine": version,
        }

    ways = {figure["key"]: way(figure) for figure in field.figures}
    spreads = spreads_of(results, field.figures)
    ranks = {figure["key"]: ranks_of(spreads, figure) for figure in field.figures}

    def told(own: Sequence[Row]) -> list[Row]:
        return [{**ways[each["figure"]], **(each["spread"] or {})} for each in own]

    def placed(summary: Row) -> Row:
        figures = [{**each, "place": ranks[each["figure"]].get(summary["method"])} for each in told(summary["figures"])]
        return {**summary, "figures": figures}

    matched = {"protocol": "one-to-one matching by IoU", "normalisation": None, "engine": version}
    title = declared()["recognition"]["title"]
    recognised = {"protocol": title, "normalisation": field.normalisation, "engine": version}
    said: Row = {
        "engine": version,
        "scale": {"normalisation": field.normalisation, "epsilon": field.epsilon},
        "results": [
            {
                **{key: value for key, value in result.items() if key not in ("scale", "figures")},
                "figures": [{**ways[key], "value": result["figures"][key]} for key in ways],
            }
            for result in results
        ],
        "summaries": [placed(summary) for summary in spreads],
        "comparisons": [{**ways[pair["figure"]], **pair} for pair in comparisons_of(results, field.figures)],
        "strata": [
            {
                "by": by["name"],
                "how": by["how"],
                "rows": [{"figure": "iou", **matched, **row} for row in strata_of(results, by)],
                "figures": [
                    {**row, "figures": told(row["figures"])} for row in spreads_by_condition(results, by, field.figures)
                ],
            }
            for by in field.by
        ],
    }
    if field.segments:
        said["recognition"] = [
            {
                "by": None if by is None else by["name"],
                "rows": [{**recognised, **row} for row in recognition_of(results, by)],
            }
            for by in [None, *field.by]
        ]
    return json_text(said)
