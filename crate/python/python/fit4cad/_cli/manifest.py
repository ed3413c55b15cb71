"""A set of models made of STEP files: which part of it a model is in, and what is written down of it."""

from __future__ import annotations

import hashlib
from typing import Any, Optional, Sequence

from .. import _engine
from .figures import json_text

Row = dict[str, Any]

#: The folders of a set that is split, as the benchmark calls them.
_TRAINING, _TEST = "training_set", "test_set"


def set_of(model: str, seed: int, test: Optional[float]) -> str:
    """The folder of a model, where there is to be a test set of some share. Drawn from its name and the seed alone: a
    part that is added moves no other."""
    if test is None:
        return ""
    drawn = int.from_bytes(hashlib.sha256(f"{seed} {model}".encode()).digest()[:4], "big") / 2**32
    return _TEST if drawn < test else _TRAINING


def manifest_of(
    made: Sequence[Row], options: Row, wear: Row, test: Optional[float], failed: Sequence[Row]
) -> str:
    """Everything that is needed to make the set again, or to see that it is the same."""
    models = []
    for each in made:
        report = each["report"]
        own = {key: value for key, value in each.items() if key != "report"}
        size = {"diagonal": report["diagonal"], "spacing": report["spacing"]}
        models.append({**own, "faces": len(report["faces"]), "leftOut": report["lost"], **size})
    types: dict[str, int] = {}
    for each in made:
        for name, count in each["types"].items():
            types[name] = types.get(name, 0) + count
    sums = {key: sum(each[key] for each in made) for key in ("points", "primitives")}
    return json_text(
        {
            "engine": _engine.__version__,
            "options": options,
            "degradation": wear,
            **({} if test is None else {"testShare": test}),
            "models": models,
            "failed": list(failed),
            "statistics": {"models": len(made), **sums, "types": types},
        }
    )
