"""The degraded sets of the standing table (``results/sets.toml``), which anyone can make anew: of which models, and what
is done to them."""

from __future__ import annotations

_TEN = [f"PC{number}" for number in (1, 2, 5, 9, 11, 14, 16, 27, 31, 33)]

#: By their names: title, models, and the options of ``degrade``.
DEGRADED: dict[str, tuple[str, list[str], dict[str, float]]] = {
    "test-10-noise": ("Ten test models, noise", _TEN, {"noise": 0.001, "seed": 1}),
    "test-10-outliers": ("Ten test models, outliers", _TEN, {"outliers": 0.05, "seed": 1}),
    "test-10-missing": ("Ten test models, missing regions", _TEN, {"missing": 0.2, "seed": 1}),
    "test-10-density": ("Ten test models, uneven density", _TEN, {"density": 10, "seed": 1}),
}
