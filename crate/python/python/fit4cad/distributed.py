"""Scoring and fitting of more models than one machine holds, on Dask.

Models are spread over the workers of a cluster that Dask knows how to start (this machine, SLURM, …) and the
results go into a folder of Parquet files, a row a model and method. A run that was cut goes on where it stopped:
rows are keyed by the SHA-256 of what went in, so that nothing is done twice and nothing stale is kept. A model that
is broken, that takes too long or takes its worker down becomes a row that says so, and stops nothing.

The figures are those of a plain loop on one machine, to the last digit.
"""

from __future__ import annotations

import contextlib
import functools
import hashlib
import itertools
import json
import os
import threading
import time
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Optional, Protocol, Union

import numpy as np

from . import _engine
from ._api import generate
from ._files import Group, Placed, StrPath, collect, grouped, texts_of, write_whole
from ._model import Model
from ._parquet import Rows, read
from ._segmentation import Segmentation
from ._tables import Row, wanted

__all__ = ["Generated", "Summary", "Task", "fit", "local", "read", "score", "tasks"]

#: Bytes of a key that are compared: two of a million models have one in 10^27.
KEY = 16
#: Beyond its time limit a model that does not listen is given this many times as long before its worker ends itself.
PATIENCE = 2.0


class Task(Protocol):
    """A model to be had on a worker; must be picklable."""

    @property
    def name(self) -> str:
        """What it is called."""

    def load(self, clouds_only: bool) -> tuple[Model, bytes]:
        """The model, and a digest of what it was made of."""


@dataclass(frozen=True)
class Generated:
    """A part of the catalogue, made where it is needed; a few bytes stand for it."""

    part: str
    name: str
    options: dict[str, float] = field(default_factory=dict)
    imperfect: bool = True
    """Whether it gets a submission that is wrong on purpose, to have something to score."""

    def load(self, clouds_only: bool) -> tuple[Model, bytes]:
        """Makes it."""
        model = generate(self.part, name=self.name, **self.options)
        if self.imperfect and not clouds_only:
            model.imperfect(int(self.options.get("seed", 1)))
        said = json.dumps([self.part, self.name, sorted(self.options.items()), self.imperfect])
        return model, hashlib.sha256(said.encode()).digest()


@dataclass(frozen=True)
class Files:
    """A model in files that every worker reaches by the same paths."""

    group: Group

    @property
    def name(self) -> str:
        """What it is called."""
        return self.group.name

    def load(self, clouds_only: bool) -> tuple[Model, bytes]:
        """Reads it."""
        sums: dict[str, Any] = {}

        def hear(path: str, content: bytes) -> None:
            sums.setdefault(path, hashlib.sha256()).update(content)

        def is_wanted(placed: Placed) -> bool:
            return not clouds_only or placed.role == "cloud"

        model = self.group.read(is_wanted, hear)
        digest = hashlib.sha256(self.name.encode())
        for path, content in sums.items():
            digest.update(hashlib.sha256(path.encode()).digest() + content.digest())
        return model, digest.digest()


Inputs = Union[StrPath, Iterable[Union[StrPath, Task]], Any]


def tasks(inputs: Inputs) -> list[Any]:
    """The models behind paths (files, folders, zips), tasks, or a ``dask.bag`` of either, in the order people count.

    Nothing is read but the names of files and the directories of zips. Raises ``InputError`` for paths that cannot
    be listed.
    """
    from ._errors import InputError

    if hasattr(inputs, "to_delayed"):
        inputs = inputs.compute()  # type: ignore[union-attr]
    if isinstance(inputs, (str, os.PathLike)) or hasattr(inputs, "load"):
        inputs = [inputs]
    given = list(inputs)
    paths = [each for each in given if isinstance(each, (str, os.PathLike))]
    own = [each for each in given if not isinstance(each, (str, os.PathLike))]
    files, problems = collect(paths)
    wrong = [problem for problem in problems if problem.severity == "error"]
    if wrong:
        raise InputError(*wrong)
    return [*(Files(group) for group in grouped(files)[0]), *own]


@dataclass(frozen=True)
class Summary:
    """What came of a run: models done now, known from before, and rows with an error; where, and how long it took."""

    out: Path
    models: int
    known: int
    failed: int
    seconds: float

    def __str__(self) -> str:
        rate = f", {self.models / self.seconds:.1f} a second" if self.models and self.seconds > 0 else ""
        return f"{self.models} models{rate}; {self.known} known, {self.failed} failed; in {self.out}"


def score(
    inputs: Inputs,
    out: StrPath,
    *,
    protocol: str = "definition",
    client: Any = None,
    batch: int = 16,
    time_limit: Optional[float] = None,
    progress: Optional[Callable[[int, int], None]] = None,
) -> Summary:
    """Scores every submission of every model; a row for each in ``out``, with every measure by its key.

    ``inputs`` are as :func:`tasks` has them. ``client`` is a ``dask.distributed.Client``; without one the current
    is taken, or one of this machine's cores is started. ``batch`` models go to a worker at once: more where models
    are small. ``time_limit`` (seconds a model, reading included) becomes a row with an ``error`` where it is
    exceeded. ``progress(done, of)`` hears how many models are done.

    Rows are kept by the SHA-256 of the files, the protocol and the engine's version: where ``out`` has a row of the
    same key already, nothing is computed. Raises ``InputError`` for paths that cannot be listed, ``ValueError`` for
    an unknown protocol, ``ModuleNotFoundError`` without dask or pyarrow.
    """
    _engine.score(_NOTHING, _EMPTY, _EMPTY, protocol)
    work = functools.partial(_score_one, protocol)
    return _run(tasks(inputs), Path(out), work, ["score", protocol], client, batch, time_limit, progress)


def fit(
    inputs: Inputs,
    out: StrPath,
    *,
    method: str = "ht",
    seed: int = 1,
    files: Optional[StrPath] = None,
    client: Any = None,
    batch: int = 4,
    time_limit: Optional[float] = None,
    progress: Optional[Callable[[int, int], None]] = None,
    **parameters: float,
) -> Summary:
    """Fits primitives to every cloud; a row for each in ``out``: how many points and primitives, and of each
    primitive its type, how many points it has, its MFE and its parametric vector.

    With ``files``, a folder that the workers reach, each submission is also written there, in the layout of the
    public test set, before its row is. The other arguments are those of :func:`score` and :func:`fit4cad.fit`.
    """
    values = {name: float(value) for name, value in parameters.items()}
    # What is wrong with the arguments is wrong with all models: said at once.
    _engine.fit(_NOTHING, method, values, seed)
    work = functools.partial(_fit_one, method, seed, values, None if files is None else str(files), time_limit)
    said = ["fit", method, seed, sorted(values.items())]
    return _run(tasks(inputs), Path(out), work, said, client, batch, time_limit, progress)


_NOTHING = _engine.Cloud(np.zeros((0, 3)))
_EMPTY = _engine.Segmentation.from_primitives(0, [])


def _score_one(protocol: str, model: Model) -> list[Row]:
    if model.truth is None:
        raise ValueError("there is no ground truth to score against")
    if not model.submissions:
        raise ValueError("there is no submission to score")
    reports = (model.score(method, protocol) for method in model.submissions)
    return [{**report.summary(), "surfaces_fitted": report.surfaces_fitted} for report in reports]


def _fit_one(
    method: str, seed: int, parameters: dict[str, float], files: Optional[str], limit: Optional[float], model: Model
) -> list[Row]:
    until = None if limit is None else time.monotonic() + limit

    def hear(stage: str, share: float) -> None:
        if until is not None and time.monotonic() > until:
            raise TimeoutError(f"it took longer than {limit:g} s")

    if len(model) == 0:
        raise ValueError("there is no point in the cloud")
    name = model.fit(method, seed=seed, progress=None if until is None else hear, **parameters)
    found: Segmentation = model.submissions[name]
    if files is not None:
        for role, text in texts_of(model, name).items():
            write_whole(Path(files) / _engine.path_of("test-set", model.name, role, name), text)
    primitives = [
        {"type": each.type, "points": len(each), "mfe": each.mfe, "parametric": None if each.parametric is None else each.parametric.tolist()}
        for each in found
    ]
    return [{"model": model.name, "method": name, "points": len(model), "found": len(found), "primitives": primitives}]


def _key(settings: str, digest: bytes) -> bytes:
    return hashlib.sha256(settings.encode() + digest).digest()[:KEY]


def _keys(joined: bytes) -> frozenset[bytes]:
    return frozenset(joined[at : at + KEY] for at in range(0, len(joined), KEY))


@contextlib.contextmanager
def _watched(limit: Optional[float]) -> Iterator[None]:
    """Ends this worker where a model does not end by itself: its nanny starts another."""
    if limit is None:
        yield
        return
    watch = threading.Timer(PATIENCE * limit + 1.0, os._exit, (1,))
    watch.daemon = True
    watch.start()
    try:
        yield
    finally:
        watch.cancel()


def _work(
    work: Callable[[Model], list[Row]],
    settings: str,
    clouds_only: bool,
    limit: Optional[float],
    batch: list[Any],
    known: frozenset[bytes],
) -> list[tuple[int, list[Row]]]:
    """What a worker does: for each model whether it was known, and its rows."""
    answers: list[tuple[int, list[Row]]] = []
    for task in batch:
        start = time.perf_counter()
        key = None
        try:
            with _watched(limit):
                model, digest = task.load(clouds_only)
                key = _key(settings, digest)
                if key in known:
                    answers.append((1, []))
                    continue
                rows = work(model)
            if limit is not None and time.perf_counter() - start > limit:
                raise TimeoutError(f"it took longer than {limit:g} s")
            error = None
        except Exception as raised:  # noqa: BLE001 -- whatever it is, it is the model's and stops no other
            rows, error = [{"model": task.name}], f"{type(raised).__name__}: {raised}"
        seconds = time.perf_counter() - start
        # What failed for reasons of its own is tried again by the next run.
        done = key if error is None else b""
        answers.append((0, [{**row, "seconds": seconds, "error": error, "key": done} for row in rows]))
    return answers


#: What Dask's workers do by the clock beside their work, for a dashboard that nobody has open: a look a hundred times a
#: second at where each of them is, and twice a second at its machine.
_QUIET = {
    "distributed.worker.profile.enabled": False,
    "distributed.admin.tick.interval": "1s",
    "distributed.admin.system-monitor.interval": "2s",
}


@contextlib.contextmanager
def local(workers: Optional[int] = None) -> Iterator[Any]:
    """A client of a cluster of this machine: so many processes of one thread each, as many as there are cores where
    none is said. :func:`score` and :func:`fit` start one by themselves where they are given no client."""
    distributed, dask = wanted("distributed"), wanted("dask")
    with dask.config.set(_QUIET):
        with distributed.LocalCluster(n_workers=workers, threads_per_worker=1, dashboard_address=None) as cluster:
            with distributed.Client(cluster) as client:
                yield client


def _client(given: Any) -> tuple[Any, Callable[[], None]]:
    distributed = wanted("distributed")
    if given is not None:
        return given, lambda: None
    try:
        return distributed.get_client(), lambda: None
    except ValueError:
        stack = contextlib.ExitStack()
        return stack.enter_context(local()), stack.close


def _run(
    all_tasks: list[Any],
    out: Path,
    work: Callable[[Model], list[Row]],
    said: list[Any],
    client: Any,
    batch: int,
    limit: Optional[float],
    progress: Optional[Callable[[int, int], None]],
) -> Summary:
    distributed = wanted("distributed")
    settings = json.dumps([_engine.__version__, *said])
    rows = Rows(out)
    client, close = _client(client)
    start, done, known, failed = time.monotonic(), 0, 0, 0
    try:
        # A task and no data that is scattered: what a worker takes along when it dies is made again.
        kept = client.submit(_keys, b"".join(sorted(rows.known())), pure=False)
        do = functools.partial(_work, work, settings, said[0] == "fit", limit)
        waiting: Iterator[list[Any]] = iter([all_tasks[at : at + batch] for at in range(0, len(all_tasks), batch)])
        flying: dict[Any, list[Any]] = {}

        def submit(batch: list[Any]) -> Any:
            future = client.submit(do, batch, kept, pure=False)
            flying[future.key] = batch
            return future

        # Enough for every worker to have the next at hand, and no more than a scheduler bears with ease.
        room = max(8, 4 * sum(client.nthreads().values()))
        ready = distributed.as_completed([submit(each) for each in itertools.islice(waiting, room)])
        for future in ready:
            own = flying.pop(future.key)
            if future.status == "finished":
                answers = future.result()
                done += sum(1 for was_known, _ in answers if not was_known)
                known += sum(was_known for was_known, _ in answers)
                failed += sum(1 for _, found in answers if any(row["error"] is not None for row in found))
                rows.add([row for _, found in answers for row in found])
            elif len(own) > 1:
                # One of them takes workers down: which, is found out one by one.
                for task in own:
                    ready.add(submit([task]))
            else:
                done, failed = done + 1, failed + 1
                why = future.exception() if future.status == "error" else future.status
                error = f"it took its worker down, again and again: {why}"
                rows.add([{"model": own[0].name, "seconds": None, "error": error, "key": b""}])
            future.release()
            following = next(waiting, None)
            if following is not None:
                ready.add(submit(following))
            if progress is not None:
                progress(done + known, len(all_tasks))
    finally:
        rows.flush()
        close()
    return Summary(out, done, known, failed, time.monotonic() - start)
