"""``fit4cad degrade``."""

from __future__ import annotations

from typing import Any, Mapping, Optional, Sequence

from .. import _engine
from .._declared import declared, names
from .._errors import Diagnostic
from .._files import Group, texts_of, unusable
from .._sets import DEGRADED
from .arguments import Option, UsageError, declared_option, numbers_of, read_arguments, some
from .figures import shown
from .models import Hear, below, each_model, found, of_truth
from .terminal import clear, make_folder, print_text, tell, telling, warn, write_file

USAGE = "PATH… [options] [--seed N] [--out DIR], or PATH… --set NAME [--out DIR]"
WORDS = "Makes worse scans of the models found in the given files, folders and zips, with their truth on the points that are left. The same model, options and seed give the same files everywhere."


def wear() -> list[dict[str, Any]]:
    """What can be done to the points of any model, the seed apart."""
    return declared()["wear"]


def _numbers() -> list[dict[str, Any]]:
    return [*wear(), *(each for each in declared()["sampleOptions"] if each["name"] == "seed")]


def options() -> Sequence[Option]:
    """The options, with those of the engine."""
    return (
        *map(declared_option, _numbers()),
        Option("set", "a degraded set of the standing table, which says all that is to be done", "NAME"),
        Option("out", "where the files go, laid out as the public test set (default: the current folder)", "DIR"),
    )


def more() -> list[tuple[str, list[tuple[str, str]]]]:
    """What the help lists besides the options."""
    said = {name: ", ".join(f"{key} {shown(value)}" for key, value in how.items()) for name, (_, _, how) in DEGRADED.items()}
    return [("Sets", [(name, f"{title}: {said[name]}") for name, (title, _, _) in DEGRADED.items()])]


def degrade(args: Sequence[str]) -> int:
    """Makes worse scans of models, with their truth; gives the exit code."""
    values, paths = read_arguments(args, options())
    only, how = _how(values["set"], numbers_of(_numbers(), values))
    some(paths, "give at least one file, folder or zip with models and their truth")
    out = values["out"] or "."
    make_folder(out)
    files, problems = found(paths)
    made: dict[str, str] = {}

    def visit(group: Group, _: Hear) -> None:
        model = group.read(of_truth)
        name = model.name.split("/")[-1]
        if model.truth is None or (only and name not in only):
            return
        texts = texts_of(model.degraded(**how))
        for role in (each for each in names("roles") if each in texts):
            path = _engine.path_of("test-set", name, role)
            if path in made:
                problems.append(_several(path, name))
            with telling(problems, path):
                write_file(below(out, path), texts[role])
                made[path] = name

    # Of files that are no model's nothing is said: a set lies among others.
    each_model(files, visit, "degrading")
    clear()
    lacking = [name for name in only if name not in made.values()]
    if lacking:
        message = f"the set has {', '.join(lacking)}, of which there is no cloud with its truth among the files"
        problems.append(unusable(values["set"] or "", message))
    failed = tell(problems)
    if not made:
        warn("fit4cad degrade: nothing was made. It needs a cloud with its truth; see fit4cad degrade --help.")
    print_text("".join(f"{below(out, path)}\n" for path in made))
    return 1 if failed or not made else 0


def _several(path: str, name: str) -> Diagnostic:
    hint = "Give the models of one set at a time"
    return unusable(path, f"there are several models called {name}; the last is kept", hint, "warning")


def _how(called: Optional[str], numbers: Mapping[str, float]) -> tuple[list[str], dict[str, float]]:
    """Which models are made worse, all where none is named, and how."""
    if called is None:
        if not any(each["name"] in numbers for each in wear()):
            every = ", ".join(f"--{each['name']} N" for each in wear())
            raise UsageError(f"say what is to be done: {every}, or --set NAME")
        return [], {"seed": 1, **numbers}
    if numbers:
        raise UsageError("--set says all that is to be done: leave the other options out")
    if called not in DEGRADED:
        raise UsageError(f"--set {called}: expected {', '.join(DEGRADED)}")
    _, models, how = DEGRADED[called]
    return models, how
