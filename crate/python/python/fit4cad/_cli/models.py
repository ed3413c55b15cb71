"""From the paths of a call to models, read one at a time, or several at once on threads of their own."""

from __future__ import annotations

import collections
import os
import re
import threading
from concurrent.futures import Future, ThreadPoolExecutor
from typing import Any, Callable, Optional, Sequence, TypeVar
from urllib.parse import unquote_to_bytes

from .._declared import names
from .._errors import Diagnostic
from .._files import File, Group, Placed, collect, grouped, unusable
from .arguments import Option, UsageError, choice
from .terminal import progress

Overrides = dict[str, dict[str, Any]]
T = TypeVar("T")

#: What the option ``--as`` can say of a file.
_KEYS = ("role", "model", "method", "first")

#: Models that are read or waited for at once, by thread: enough that none of them idles behind a slow one.
_AHEAD = 4

AS = Option("as", "what is known better about a file than its name tells", "role=R,model=M,method=N,first=F:FILE", many=True)


class _Stopped(Exception):
    """The call is over: what a thread is still at is of no use."""


def found(paths: Sequence[str]) -> tuple[list[File], list[Diagnostic]]:
    """The files behind the paths, and what could not be listed."""
    progress("looking for files")
    return collect(paths)


def of_truth(placed: Placed) -> bool:
    """Whether a file is the cloud or of the ground truth, and no method's."""
    return placed.method is None


def of_cloud(placed: Placed) -> bool:
    """Whether a file is the cloud."""
    return placed.role == "cloud"


Hear = Callable[[str, float], None]


def each_model(
    files: list[File],
    visit: Callable[[Group, Hear], T],
    doing: str,
    *,
    overrides: Optional[Overrides] = None,
    jobs: int = 1,
) -> tuple[list[T], list[Diagnostic], list[Diagnostic]]:
    """What ``visit`` makes of each model among the files, in the order people count. Gives also what belongs to no
    model, and what the engine could not bear: the others go on.

    ``visit`` gets what is to hear of the progress of a fit. With several jobs it runs on threads, without Python's
    lock wherever the engine is at work.
    """
    groups, unplaced = grouped(files, overrides, imports=False)
    stops: list[Diagnostic] = []
    answers: list[T] = []
    over = threading.Event()

    def begin(at: int) -> str:
        place = f"{doing} {at + 1} of {len(groups)}: {groups[at].name}"
        progress(place)
        return place

    def take(group: Group, give: Callable[[], T]) -> None:
        try:
            answers.append(give())
        except BaseException as error:
            if not (isinstance(error, MemoryError) or type(error).__name__ == "PanicException"):
                raise
            hint = "Thin the cloud, or score fewer results at a time"
            stops.append(unusable(group.name, "the engine ran out of memory, or failed, on this model", hint))

    if jobs <= 1:
        for at, group in enumerate(groups):
            place = begin(at)
            take(group, lambda: visit(group, lambda stage, part: progress(f"{place}, {stage} {round(100 * part)} %")))
        return answers, unplaced, stops

    def hear(stage: str, part: float) -> None:
        if over.is_set():
            raise _Stopped

    with ThreadPoolExecutor(jobs) as threads:
        try:
            flying: collections.deque[tuple[Group, Future[T]]] = collections.deque()
            for at, group in enumerate(groups):
                if len(flying) >= _AHEAD * jobs:
                    first, future = flying.popleft()
                    take(first, future.result)
                begin(at)
                flying.append((group, threads.submit(visit, group, hear)))
            while flying:
                first, future = flying.popleft()
                take(first, future.result)
        except BaseException:
            over.set()
            for _, future in flying:
                future.cancel()
            raise
    return answers, unplaced, stops


def corrections(given: Sequence[str], files: Sequence[File]) -> Overrides:
    """What ``--as`` says, by path. In a name ``%2C`` stands for a comma, ``%3A`` for a colon, ``%25`` for a per cent sign."""
    overrides = dict(map(_correction, given))
    known = {file.path for file in files}
    for path in overrides:
        if path not in known:
            raise UsageError(f"--as …:{path}: there is no such file among those given")
    return overrides


def _correction(value: str) -> tuple[str, dict[str, Any]]:
    said, colon, path = value.partition(":")
    if not colon or not path:
        raise UsageError(
            f"--as {value}: expected role=…,model=…,method=…,first=…:FILE, as many of the four as are to be corrected"
        )
    return path, dict(_key_and_name(pair, value) for pair in said.split(","))


def _key_and_name(pair: str, value: str) -> tuple[str, Any]:
    key, equal, name = pair.partition("=")
    if not equal or key not in _KEYS:
        raise UsageError(f"--as {value}: expected {', '.join(f'{known}=…' for known in _KEYS)} before the colon")
    if key == "role":
        choice("as role", name, names("roles"))
    if key == "first":
        return key, int(choice("as first", name, ["0", "1"]))
    try:
        if re.search("%(?![0-9A-Fa-f]{2})", name):
            raise ValueError(name)
        return key, unquote_to_bytes(name).decode()
    except ValueError as error:
        raise UsageError(f"--as {value}: write %25 for a per cent sign") from error


def below(out: str, path: str) -> str:
    """A path below a folder."""
    return os.path.normpath(os.path.join(out, path))
