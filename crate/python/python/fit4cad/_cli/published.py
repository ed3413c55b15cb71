"""The paper's two methods as rows beside one's own, on the models that are its test models."""

from __future__ import annotations

import functools
import json
from typing import Any, Optional, Sequence

from .. import _engine
from .._declared import names

Row = dict[str, Any]

#: In the order of the page.
_METHODS = ("HT", "PG")


@functools.lru_cache(maxsize=1)
def _published() -> Row:
    found: Row = json.loads(_engine.PUBLISHED)
    return found


def _test_model(result: Row) -> Optional[Row]:
    """The test model that a result is of: by name, points and true primitives, as a name alone proves nothing."""
    own = result["model"].split("/")[-1].lower()
    test: Optional[Row] = next((model for name, model in _published()["models"].items() if name.lower() == own), None)
    alike = test is not None and all(test[key] == result[key] for key in ("points", "truth"))
    return test if alike else None


def with_published(results: Sequence[Row]) -> list[Row]:
    """The results, and after those of each test model the published ones, by the same protocol."""
    taken = {each["method"] for each in results}
    rows: list[Row] = []
    for at, result in enumerate(results):
        rows.append(result)
        test = _test_model(result)
        if test is None or (at + 1 < len(results) and results[at + 1]["model"] == result["model"]):
            continue
        for method in _METHODS:
            called = f"{method} (published)"
            # Figures of two are never put under one name.
            while called in taken:
                called += "*"
            figures = dict(zip(_published()["measures"], test[method][result["protocol"]]))
            rows.append(
                {
                    **{key: result[key] for key in ("model", "protocol", "points", "truth")},
                    **{"method": called, "predicted": None, "type_errors": None, "engine": "", "files": [], "published": True},
                    "mean": {measure: figures.get(measure) for measure in names("measures")},
                }
            )
    return rows
