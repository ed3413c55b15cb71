"""What the engine declares: read from it once, typed nowhere else."""

from __future__ import annotations

import functools
from typing import Any

from . import _engine


@functools.lru_cache(maxsize=1)
def _declared() -> dict[str, Any]:
    return _engine.declarations()


def declared() -> dict[str, Any]:
    """Measures, protocols, figures of the field, types of surfaces, fitters with their parameters, parts, options
    of sampling, roles and kinds of files and forms of export, each a list of dictionaries with names, units,
    ranges, defaults and words, under the keys of the page's and the command line's lists."""
    return _declared()


def names(kind: str) -> list[str]:
    """The names in one of the lists of :func:`declared`."""
    return [one.get("key", one.get("name")) for one in declared()[kind]]
