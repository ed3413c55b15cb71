"""``fit4cad fit``."""

from __future__ import annotations

import time
from dataclasses import dataclass
from typing import Any, Mapping, Optional, Sequence

from .. import _engine
from .._declared import declared, names
from .._errors import Diagnostic
from .._files import Group, texts_of, unusable
from .._model import Model
from .arguments import FORMATS, JOBS, Option, UsageError, choice, declared_option, format_of, jobs_of, number, read_arguments, some
from .figures import align, fixed, json_text, scientific
from .models import Hear, below, each_model, found, of_cloud
from .single import recognise
from .terminal import NotWritten, clear, make_folder, print_text, tell, warn, write_file

Row = dict[str, Any]


def _flag(name: str) -> str:
    return name.replace("_", "-")


def _parameters() -> dict[str, tuple[Row, list[str]]]:
    """Every parameter of any method, each once, with the methods that heed it."""
    found: dict[str, tuple[Row, list[str]]] = {}
    for fitter in declared()["fitters"]:
        for info in fitter["parameters"]:
            found.setdefault(info["name"], (info, []))[1].append(fitter["name"])
    return found


def options() -> Sequence[Option]:
    """The options, with the parameters of the methods."""
    parameters = [declared_option(info) for info, _ in _parameters().values()]
    return (
        Option("method", "which finds the primitives", "|".join(names("fitters"))),
        Option("out", "folder that gets the submissions, in the layout of the public test set", "DIR"),
        *FORMATS,
        Option("seed", "of everything random (default 1); the same seed gives the same primitives"),
        Option("single", "instead of a method: the cloud, or each segment given with it, is one primitive", None),
        JOBS,
        *parameters,
    )


USAGE = f"--method {'|'.join(names('fitters'))} [--out DIR] [--format table|json] [--seed N] [--jobs N] [parameters] PATH…"
WORDS = "Finds the primitives of every cloud in the given files, folders and zips. Only the clouds are read."


def more() -> list[tuple[str, list[tuple[str, str]]]]:
    """What the help lists besides the options."""
    return [("Methods", [(each["name"], f"{each['title']}, {each['fullName']}. {each['meaning']}") for each in declared()["fitters"]])]


def _given(method: str, values: Mapping[str, Any]) -> dict[str, float]:
    given = {}
    for name, (info, methods) in _parameters().items():
        text = values[_flag(name)]
        if text is None:
            continue
        if method not in methods:
            raise UsageError(f"--{_flag(name)} is of method {', '.join(methods)}; {method} has no such parameter")
        value = number(_flag(name), text, least=info["minimum"], most=info["maximum"], whole=info["whole"])
        assert value is not None
        given[name] = value
    return given


@dataclass
class Fitted:
    """What became of one model: what is told of it, and of its files."""

    row: Optional[Row]
    problems: list[Diagnostic]


def fit(args: Sequence[str]) -> int:
    """Fits what the arguments name; gives the exit code."""
    values, paths = read_arguments(args, options())
    if values["single"]:
        return _single(values, paths)
    if values["method"] is None:
        raise UsageError(f"choose a method: {' or '.join(f'--method {name}' for name in names('fitters'))}")
    method = choice("method", values["method"].lower(), names("fitters"))
    form = format_of(values, ["table", "json"])
    seed = number("seed", values["seed"], least=0, most=2**32 - 1, whole=True)
    parameters = _given(method, values)
    jobs = jobs_of(values)
    some(paths)
    out = values["out"]
    if out is not None:
        # Before anything is fitted that could then not be kept.
        make_folder(out)

    def visit(group: Group, hear: Hear) -> Fitted:
        model = group.read(of_cloud)
        if len(model) == 0:
            return Fitted(None, model.diagnostics)
        start = time.perf_counter()
        try:
            name = model.fit(method, seed=1 if seed is None else int(seed), progress=hear, **parameters)
        except ValueError as error:
            # A parameter may suit the other clouds.
            return Fitted(None, [*model.diagnostics, unusable(model.name, str(error))])
        seconds = time.perf_counter() - start
        found = model.submissions[name]
        rows = [
            {
                **{"type": one.type, "points": len(one), "mfe": one.mfe},
                "surface": None if one.surface is None else one.surface.to_dict(),
                "standardErrors": one.standard_errors.to_dict(),
            }
            for one in found
        ]
        about = {"engine": _engine.__version__, "model": model.name, "points": len(model), "seconds": seconds}
        error = {} if out is None else _written(model, name, out)
        return Fitted({**about, "noise": found._native.noise(), "primitives": rows, "types": found.types, **error}, model.diagnostics)

    files, problems = found(paths)
    models, unplaced, stops = each_model(files, visit, "fitting", jobs=jobs)
    clear()
    failed = tell([*problems, *unplaced, *stops, *(problem for each in models for problem in each.problems)])
    fitted = [each.row for each in models if each.row is not None]
    for row in fitted:
        if "error" in row:
            failed = True
            warn(f"fit4cad fit: {row['error']}")
    if not fitted:
        warn("fit4cad fit: there was no cloud to fit; see fit4cad fit --help.")
    print_text(json_text(fitted) if form == "json" else _table(fitted))
    return 1 if failed or not fitted else 0


def _single(values: Mapping[str, Any], paths: Sequence[str]) -> int:
    if values["method"] is not None:
        raise UsageError("--single takes no method: it tries every type of surface")
    if values["jobs"] is not None:
        raise UsageError("--single takes no --jobs: it is quick")
    some(paths)
    return recognise(paths, out=values["out"], as_json=format_of(values, ["table", "json"]) == "json")


def _written(model: Model, method: str, out: str) -> Row:
    try:
        for role, text in texts_of(model, method).items():
            write_file(below(out, _engine.path_of("test-set", model.name, role, method)), text)
    except NotWritten as error:
        return {"error": str(error)}
    return {}


def _noise(noise: Mapping[str, Any]) -> str:
    return f"{scientific(noise['deviation'], 1)} {noise['source']}"


def _table(fitted: Sequence[Row]) -> str:
    if not fitted:
        return ""
    types = names("surfaceTypes")
    rows = [["model", "points", "seconds", "primitives", *map(str.lower, types), "noise"]]
    for each in fitted:
        counts = (str(each["types"][name]) for name in types)
        rows.append([each["model"], str(each["points"]), fixed(each["seconds"], 3), str(len(each["primitives"])), *counts, _noise(each["noise"])])
    return f"{align(rows, 1)}\n"
