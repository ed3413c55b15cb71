"""The command line: what ``npx fit4cad`` calls ``score``, ``fit``, ``export``, ``check`` and ``generate``, with its
words and its JSON. ``import``, ``stats``, ``fit --single``, ``--jobs``, the protocols of the field and the formats CSV,
LaTeX and Markdown are of that one alone; here they are functions of the package."""

from __future__ import annotations

import argparse
import contextlib
import hashlib
import json
import os
import sys
import time
from pathlib import Path
from typing import Any, Callable, Iterator, Optional, Sequence

from . import _engine
from ._declared import declared, names
from ._errors import Diagnostic, InputError
from ._files import STEP, Group, Placed, collect, export, grouped, texts_of, unusable, write_whole
from ._model import Model

ROLES_OF_SEGMENTATION = ("primitives", "parametric", "implicit")


class _Parser(argparse.ArgumentParser):
    def error(self, message: str) -> Any:  # type: ignore[override]
        raise _Usage(message)


class _Usage(Exception):
    """The command was called wrongly."""


def _parser() -> argparse.ArgumentParser:
    parser = _Parser(prog="fit4cad", description="fit, score and make segmentations of CAD point clouds, as the "
                     "Fit4CAD benchmark does", epilog=__doc__)
    parser.add_argument("--version", "-V", action="version", version=f"fit4cad {_engine.__version__}")
    commands = parser.add_subparsers(dest="command", required=True, parser_class=_Parser)

    def command(name: str, words: str, run: Callable[[argparse.Namespace], int], paths: bool = True) -> Any:
        one = commands.add_parser(name, help=words, description=words)
        one.set_defaults(run=run)
        if paths:
            one.add_argument("paths", nargs="+", metavar="PATH", help="files, folders and zips")
        return one

    def formats(one: Any) -> None:
        one.add_argument("--format", choices=["table", "json"], default=None)
        one.add_argument("--json", action="store_true", help="short for --format json")

    score = command("score", "score submissions against the ground truth", _score)
    said = "; ".join(f"{each['name']}: {each['meaning']}" for each in declared()["protocols"])
    score.add_argument("--protocol", choices=names("protocols"), default=names("protocols")[0], help=_plain(said))
    score.add_argument("--self", action="store_true", dest="itself", help="scores the truth against itself")
    score.add_argument("--as", action="append", default=[], dest="corrections", metavar="role=R,model=M,method=N,first=F:FILE")
    formats(score)

    fit = command("fit", "find the primitives of clouds", _fit)
    fit.add_argument("--method", choices=names("fitters"), required=True, type=str.lower)
    fit.add_argument("--out", help="folder that gets the submissions, in the layout of the public test set")
    fit.add_argument("--seed", type=_number({"name": "seed", "minimum": 0, "maximum": 2**32 - 1, "whole": True}), default=1)
    for info in {each["name"]: each for fitter in declared()["fitters"] for each in fitter["parameters"]}.values():
        fit.add_argument(f"--{info['name'].replace('_', '-')}", type=_number(info), metavar="N", help=_plain(info["explanation"]))
    formats(fit)

    check = command("check", "find errors in a ground truth, and correct them", _check)
    check.add_argument("--write", metavar="DIR", help="folder that gets corrected surface files")
    formats(check)

    out = command("export", "write segmentations as tables, labelled points and meshes", _export)
    out.add_argument("--to", action="append", required=True, metavar="FORM", help=", ".join(_forms()))
    out.add_argument("--method")
    out.add_argument("--out", default=".")

    make = command("generate", "make a model with known ground truth", _generate, paths=False)
    make.add_argument("part", nargs="?")
    make.add_argument("--list", action="store_true", help="the parts it can make")
    for info in declared()["sampleOptions"]:
        make.add_argument(f"--{info['name']}", type=_number(info), metavar="N", help=_plain(info["explanation"]))
    make.add_argument("--imperfect", action="store_true", help="adds a submission that is wrong on purpose")
    make.add_argument("--name")
    make.add_argument("--out", default=".")
    return parser


def _plain(words: str) -> str:
    return words.replace("%", "%%")


def _number(info: dict[str, Any]) -> Callable[[str], float]:
    """A number of the declared range, as argparse takes it."""

    def parse(text: str) -> float:
        least, most, whole = info["minimum"], info["maximum"], info["whole"]
        try:
            value = float(text)
        except ValueError:
            value = float("nan")
        if not least <= value <= most or (whole and value != int(value)):
            kind = "a whole number" if whole else "a number"
            raise argparse.ArgumentTypeError(f"{text}: expected {kind} from {least:g} to {most:g}")
        return int(value) if whole else value

    return parse


def main(args: Sequence[str]) -> int:
    """Runs the command line; gives the exit code: 0 all well, 1 some input unusable, 2 called wrongly."""
    try:
        if not args:
            _parser().print_help(sys.stderr)
            return 2
        given = _parser().parse_args(args)
        return given.run(given)
    except _Usage as error:
        return _failed(args, str(error), 2)
    except (InputError, OSError) as error:
        return _failed(args, str(error), 1)
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 0
    except KeyboardInterrupt:
        return 130


def _failed(args: Sequence[str], message: str, code: int) -> int:
    _warn(f"fit4cad: {message}")
    if "--json" in args or "--format=json" in args or "json" in args:
        print(json.dumps({"error": message}, indent=2))
    return code


def _warn(text: str) -> None:
    print("".join("\ufffd" if not each.isprintable() else each for each in text), file=sys.stderr)


def _asks_json(given: argparse.Namespace) -> bool:
    if given.json and given.format not in (None, "json"):
        raise _Usage(f"--json and --format {given.format}: expected one format")
    return given.json or given.format == "json"


def _print_json(value: Any) -> None:
    print(json.dumps(value, indent=2, ensure_ascii=False))


def _align(rows: list[list[str]], text_columns: int) -> str:
    widths = [max(len(row[at]) for row in rows) for at in range(len(rows[0]))]
    cells = lambda row: (  # noqa: E731
        text.ljust(width) if at < text_columns else text.rjust(width) for at, (text, width) in enumerate(zip(row, widths))
    )
    return "\n".join("  ".join(cells(row)).rstrip() for row in rows)


def _tell(problems: list[Diagnostic]) -> bool:
    """Tells each in a line; gives whether one is an error."""
    for problem in problems:
        _warn(str(problem))
    return any(problem.severity == "error" for problem in problems)


def _groups(paths: Sequence[str], problems: list[Diagnostic], overrides: Any = None) -> Iterator[Group]:
    files, wrong = collect(paths)
    problems += wrong
    unread = [file for file in files if file.path.lower().endswith(STEP)]
    problems += [unusable(file.path, "STEP files are read by `npx fit4cad import`, or by fit4cad.read", severity="warning") for file in unread]
    files = [file for file in files if file not in unread]
    for path in set(overrides or {}) - {file.path for file in files}:
        raise _Usage(f"--as …:{path}: there is no such file among those given")
    groups, unplaced = grouped(files, overrides)
    problems += unplaced
    yield from groups


def _of_truth(placed: Placed) -> bool:
    return placed.method is None


def _corrections(given: Sequence[str]) -> dict[str, dict[str, Any]]:
    from urllib.parse import unquote

    found: dict[str, dict[str, Any]] = {}
    for value in given:
        pairs, colon, path = value.partition(":")
        if not colon or not path:
            raise _Usage(f"--as {value}: expected role=…,model=…,method=…,first=…:FILE")
        known: dict[str, Any] = {}
        for pair in pairs.split(","):
            key, equal, name = pair.partition("=")
            if not equal or key not in ("role", "model", "method", "first"):
                raise _Usage(f"--as {value}: expected role=…, model=…, method=…, first=… before the colon")
            if key == "role" and name not in names("roles") or key == "first" and name not in ("0", "1"):
                raise _Usage(f"--as {key} {name}: expected {', '.join(names('roles') if key == 'role' else ['0', '1'])}")
            known[key] = int(name) if key == "first" else unquote(name)
        found[path] = known
    return found


def _score(given: argparse.Namespace) -> int:
    wants_json, overrides = _asks_json(given), _corrections(given.corrections)
    problems: list[Diagnostic] = []
    results, reports = [], []
    for group in _groups(given.paths, problems, overrides):
        sums: dict[str, str] = {}

        def hear(path: str, content: bytes, sums: dict[str, str] = sums) -> None:
            sums[path] = hashlib.sha256(content).hexdigest()

        model = group.read(_of_truth, hear) if given.itself else group.read(hear=hear)
        told = model.diagnostics
        if model.truth is None:
            hint = f"Give {model.name}_primitives.txt of the benchmark as well"
            problems += [*told, unusable(model.name, "there is no ground truth to score against", hint)]
            continue
        if not given.itself and not model.submissions:
            hint = ("Give a method's files in a folder named after it (pointCloud_primitives_MINE), or score the truth "
                    "against itself with --self")
            problems += [*told, unusable(model.name, "there is no submission to score", hint, "note")]
            continue
        listed = []
        for placed in group.files:
            if placed.file.path in sums:
                whose = {} if placed.method is None else {"method": placed.method}
                listed.append({"path": placed.file.path, "role": placed.role, **whose, "sha256": sums[placed.file.path]})
        shown = set()
        for method in [None] if given.itself else list(model.submissions):
            report = model.score(method, given.protocol)
            reports.append(report)
            own = [each for each in listed if each.get("method") in (None, report.method)]
            results.append({**report.to_dict(), "engine": _engine.__version__, "files": own})
            shown |= {str(each) for each in report.diagnostics}
        problems += [each for each in told if not (wants_json and str(each) in shown)]
    failed = _tell(problems)
    if not reports:
        _warn("fit4cad score: nothing could be scored. A score needs a cloud, its truth and a submission.")
    if wants_json:
        _print_json(results)
    elif reports:
        measures = names("measures")
        figure = lambda value: "n/a" if value is None else f"{value:.4f}"  # noqa: E731
        rows = [["model", "method", "points", "truth", "predicted", *measures, "type errors"]]
        for report in reports:
            counts = map(str, (report.points, report.truth, report.predicted))
            called = f"{report.method} †" if report.surfaces_fitted else report.method
            rows.append([report.model, called, *counts, *(figure(report[key]) for key in measures), str(report.type_errors)])
        for summary in _engine.summarise([(each.method, each.mean, each.type_errors) for each in reports]):
            if summary["models"] > 1:
                means = (figure(summary["over"].get(key, {}).get("mean")) for key in measures)
                rows.append([f"mean of {summary['models']}", summary["method"], "", "", "", *means, str(summary["typeErrors"])])
        print(_align(rows, 2))
        if any(report.surfaces_fitted for report in reports):
            print("† came without surfaces: types, MFE, dHaus and distances of parameters are of those fitted here")
    return 1 if failed or not reports else 0


def _fit(given: argparse.Namespace) -> int:
    wants_json = _asks_json(given)
    heeded = {each["name"] for fitter in declared()["fitters"] if fitter["name"] == given.method for each in fitter["parameters"]}
    every = {each["name"] for fitter in declared()["fitters"] for each in fitter["parameters"]}
    parameters = {name: getattr(given, name) for name in every if getattr(given, name) is not None}
    for name in sorted(set(parameters) - heeded):
        raise _Usage(f"--{name.replace('_', '-')} is of another method; {given.method} has no such parameter")
    problems: list[Diagnostic] = []
    fitted: list[dict[str, Any]] = []
    for group in _groups(given.paths, problems):
        model = group.read(lambda placed: placed.role == "cloud")
        problems += model.diagnostics
        if len(model) == 0:
            continue
        start = time.perf_counter()
        method = model.fit(given.method, seed=given.seed, **parameters)
        seconds = time.perf_counter() - start
        found = model.submissions[method]
        error = {} if given.out is None else _written(model, method, Path(given.out))
        rows = [{"type": one.type, "points": len(one), "mfe": one.mfe} for one in found]
        about = {"engine": _engine.__version__, "model": model.name, "points": len(model), "seconds": seconds}
        fitted.append({**about, "primitives": rows, "types": found.types, **error})
    failed = _tell(problems)
    for each in fitted:
        if "error" in each:
            failed = True
            _warn(f"fit4cad fit: {each['error']}")
    if not fitted:
        _warn("fit4cad fit: there was no cloud to fit.")
    if wants_json:
        _print_json(fitted)
    elif fitted:
        types = names("surfaceTypes")
        table = [["model", "points", "seconds", "primitives", *map(str.lower, types)]]
        for each in fitted:
            counts = (str(each["types"][name]) for name in types)
            table.append([each["model"], str(each["points"]), f"{each['seconds']:.3f}", str(len(each["primitives"])), *counts])
        print(_align(table, 1))
    return 1 if failed or not fitted else 0


def _written(model: Model, method: str, out: Path) -> dict[str, str]:
    try:
        for role, text in texts_of(model, method).items():
            write_whole(out / _engine.path_of("test-set", model.name, role, method), text)
    except OSError as error:
        return {"error": f"{error.filename or out} could not be written: {error.strerror}"}
    return {}


def _check(given: argparse.Namespace) -> int:
    wants_json = _asks_json(given)
    problems: list[Diagnostic] = []
    audits = []
    for group in _groups(given.paths, problems):
        model = group.read(_of_truth)
        audit = model.check()
        audits.append(audit)
        if model.truth is None:
            hint = f"Give {model.name}_primitives.txt as well"
            problems.append(unusable(model.name, "there is no ground truth to check", hint))
        elif given.write is not None:
            for form, text in audit.corrected.items():
                path = write_whole(Path(given.write) / _engine.path_of("beside", model.name, form), text)
                replaced = ", ".join(str(each["primitive"]) for each in audit.corrections if each["form"] == form)
                _warn(f"wrote {path}: replaced the vectors of primitives {replaced}")
    failed = _tell(problems)
    if not audits:
        _warn("fit4cad check: nothing could be checked. A check needs a cloud and its truth.")
    if wants_json:
        _print_json([{"engine": _engine.__version__, **audit.to_dict()} for audit in audits])
    elif audits:
        rows = [["model", "primitive", "severity", "check", "finding"]]
        for audit in audits:
            for each in audit.findings:
                said = each.message + (f". {each.hint}" if each.hint else "")
                rows.append([audit.model, "" if each.primitive is None else str(each.primitive), each.severity, each.check, said])
        if len(rows) > 1:
            print(_align(rows, len(rows[0])))
        counts = [sum(each.severity == word for audit in audits for each in audit.findings) for word in ("error", "warning", "note")]
        counted = lambda number, noun: f"{number} {noun}{'' if number == 1 else 's'}"  # noqa: E731
        parts = ", ".join(map(counted, counts, ("error", "warning", "note")))
        print(f"{counted(len(audits), 'model')}, {counted(sum(len(audit.primitives) for audit in audits), 'primitive')}: {parts}")
    return 1 if failed or not audits or not all(audit.ok for audit in audits) else 0


def _forms() -> list[str]:
    return [*names("exports"), "step", "fit4cad"]


def _export(given: argparse.Namespace) -> int:
    forms = [form for words in given.to for form in words.split(",")]
    for form in forms:
        if form not in _forms():
            raise _Usage(f"--to {form}: expected {', '.join(_forms())}")
    endings = {each["name"]: each["ending"] for each in declared()["exports"]} | {"step": "_surfaces.step"}
    problems: list[Diagnostic] = []
    written: list[Path] = []
    out = Path(given.out)
    for group in _groups(given.paths, problems):
        model = group.read()
        problems += model.diagnostics
        every = [*([] if model.truth is None else ["truth"]), *model.submissions]
        wanted = [called for called in every if given.method in (None, called)]
        if not wanted:
            problems.append(unusable(model.name, "there is no segmentation to export", f"There is {', '.join(every) or 'none at all'}"))
        for called in wanted:
            method = None if called == "truth" else called
            # The engine makes names that every file system takes, and that lead out of no folder.
            stem = _engine.path_of("beside", f"{model.name}_{called}", "cloud")[: -len(".txt")]
            for form in forms:
                if form == "fit4cad":
                    texts = texts_of(model) if method is None else {**texts_of(model, method), "cloud": texts_of(model)["cloud"]}
                    for role, text in texts.items():
                        owner = None if role == "cloud" else method
                        written.append(write_whole(out / _engine.path_of("test-set", model.name, role, owner), text))
                else:
                    written.append(write_whole(out / (stem + endings[form]), export(model, form, method)))
    failed = _tell(problems)
    if not written:
        _warn("fit4cad export: nothing was written. An export needs a cloud and segments of it.")
    for path in written:
        print(path)
    return 1 if failed or not written else 0


def _generate(given: argparse.Namespace) -> int:
    from ._api import generate

    parts = declared()["parts"]
    if given.list:
        width = max(len(part["name"]) for part in parts)
        for part in parts:
            print(f"{part['name'].ljust(width)}  {part['description']}")
        return 0
    if given.part is None:
        raise _Usage("give one part; --list shows them")
    if given.part not in names("parts"):
        raise _Usage(f'there is no part "{given.part}"; --list shows what there is')
    name = given.name or given.part
    if "/" in name or "\\" in name:
        raise _Usage(f"--name {name}: expected a name of files, without folders")
    options = {each["name"]: getattr(given, each["name"]) for each in declared()["sampleOptions"]}
    try:
        model = generate(given.part, name=name, **{key: value for key, value in options.items() if value is not None})
    except ValueError as error:
        raise _Usage(str(error)) from error
    methods: list[Optional[str]] = [None]
    if given.imperfect:
        methods.append(model.imperfect(int(options["seed"] or 1)))
    for method in methods:
        for role, text in texts_of(model, method).items():
            with contextlib.suppress(BrokenPipeError):
                print(write_whole(Path(given.out) / _engine.path_of("beside", name, role, method), text))
    return 0
