"""How far something is: a callback, a bar of tqdm, or nothing."""

from __future__ import annotations

import contextlib
from typing import Any, Callable, Iterator, Optional, Union

from ._declared import declared

Progress = Union[Callable[[str, float], None], bool, None]
Counted = Union[Callable[[int, int], None], bool, None]


def _bar(**how: Any) -> Any:
    """A bar of tqdm, or nothing where it is not installed."""
    try:
        from tqdm.auto import tqdm  # type: ignore[import-untyped]
    except ModuleNotFoundError:
        return None
    return tqdm(**how)


@contextlib.contextmanager
def of_fit(progress: Progress) -> Iterator[Optional[Callable[[str, float], None]]]:
    """What hears the stages of a fit: ``True`` stands for a bar of tqdm."""
    if progress is not True:
        yield progress or None
        return
    bar = _bar(total=100, bar_format="{desc:8} {percentage:3.0f} %|{bar}| {elapsed}")
    if bar is None:
        yield None
        return
    before, shares = {}, 0.0
    for stage in declared()["stages"]:
        before[stage["name"]] = (shares, stage["share"])
        shares += stage["share"]

    def hear(stage: str, fraction: float) -> None:
        start, share = before[stage]
        bar.set_description_str(stage, refresh=False)
        bar.update(100 * (start + share * fraction) - bar.n)

    with bar:
        yield hear
        bar.update(100 - bar.n)


@contextlib.contextmanager
def of_many(progress: Counted, what: str) -> Iterator[Optional[Callable[[int, int], None]]]:
    """What hears how many of a batch are done: ``True`` stands for a bar of tqdm."""
    if progress is not True:
        yield progress or None
        return
    bar = _bar(desc=what, unit="model")
    if bar is None:
        yield None
        return

    def hear(done: int, of: int) -> None:
        bar.total = of
        bar.update(done - bar.n)

    with bar:
        yield hear
