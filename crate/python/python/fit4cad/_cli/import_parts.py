"""``fit4cad import``."""

from __future__ import annotations

import hashlib
import os
from dataclasses import dataclass
from typing import Any, Mapping, Optional, Sequence

from .. import _engine
from .._declared import declared, names
from .._errors import Diagnostic
from .._files import STEP, File, is_step, name_of_part, texts_of, unusable, why_unread
from .._model import Model
from .._segmentation import Segmentation
from .arguments import FORMATS, Option, UsageError, choice, declared_option, format_of, number, numbers_of, read_arguments, some
from .degrade import wear
from .figures import align, json_text, precise
from .manifest import manifest_of, set_of
from .models import found
from .terminal import NotWritten, clear, make_folder, print_text, progress, tell, warn, write_file

Row = dict[str, Any]

_CALLED = ", ".join(STEP)

USAGE = "PATH… [--points N | --spacing MM] [options] [--out DIR] [--test SHARE] [--format table|json]"
WORDS = f"Makes a Fit4CAD model of every STEP file (AP203, AP214, AP242; {_CALLED}, also packed by gzip) in the given files, folders and zips: points that lie exactly on its faces, in millimetres, and the truth. Of more than one model, or with --test, DIR/manifest.json says how the set was made."


def options() -> Sequence[Option]:
    """The options, with those of the reader of STEP and of the engine."""
    value = {"number": "N", "flag": None}
    return (
        *(Option(each["name"], each["explanation"], value.get(each["value"]["kind"], "WORD")) for each in declared()["importOptions"]),
        *map(declared_option, wear()),
        Option("bodies", "only these bodies, by their numbers from 1 in the order of the file (default: all)", "N,N"),
        Option("out", "where the files go (default: the current folder); made if missing", "DIR"),
        Option("test", "splits the models into DIR/training_set and DIR/test_set, by their names and the seed", "SHARE"),
        *FORMATS,
    )


def import_parts(args: Sequence[str]) -> int:
    """Makes models of the STEP files that the arguments name; gives the exit code."""
    values, paths = read_arguments(args, options())
    form = format_of(values, ["table", "json"])
    asked = _options(values)
    worn = numbers_of(wear(), values)
    bodies = _bodies(values["bodies"])
    test = number("test", values["test"], least=0, most=1)
    some(paths, "give at least one STEP file, or a folder or zip of them")
    out = values["out"] or "."
    make_folder(out)
    files, problems = found(paths)
    # What is named outright is tried whatever its name; of folders and zips only what is called like STEP.
    parts = [file for file in files if is_step(file.path) or file.path in paths]
    run = Run(asked, bodies, worn, out, test)
    for at, part in enumerate(parts):
        progress(f"importing {at + 1} of {len(parts)}: {os.path.basename(part.path)}")
        run.take(part)
    clear()
    problems += run.problems
    if len(run.made) > 1 or test is not None:
        path = os.path.normpath(os.path.join(out, "manifest.json"))
        try:
            write_file(path, manifest_of(run.made, {**asked, **({} if bodies is None else {"bodies": bodies})}, worn, test, run.failed))
        except NotWritten as error:
            problems.append(unusable(path, str(error)))
    failed = tell(problems)
    if not parts:
        warn(f"fit4cad import: there was no STEP file ({_CALLED}, also .gz); see fit4cad import --help.")
    told = [{"engine": _engine.__version__, **made} for made in run.made]
    print_text(json_text(told) if form == "json" else _table(run.made))
    return 1 if failed or not run.made else 0


def _options(values: Mapping[str, Any]) -> Row:
    """The options of the import among the values given."""
    given: Row = numbers_of([{"name": it["name"], **it["value"]} for it in declared()["importOptions"] if it["value"]["kind"] == "number"], values)
    for each in declared()["importOptions"]:
        name, word = each["name"], values[each["name"]]
        if each["value"]["kind"] == "choice" and word is not None:
            given[name] = choice(name, word, each["value"]["words"])
        elif word is True:
            given[name] = True
    if "points" in given and "spacing" in given:
        raise UsageError("give --points or --spacing, not both")
    return given


def _bodies(word: Optional[str]) -> Optional[list[int]]:
    """The numbers of bodies asked for, separated by commas; ``None`` for all."""
    if word is None:
        return None
    numbers = [number("bodies", each.strip(), least=1, most=2**32 - 1, whole=True) for each in word.split(",")]
    return [int(each) for each in numbers if each is not None]


@dataclass
class Run:
    """One run of the command: how it goes, what was made so far, and what went wrong."""

    options: Row
    bodies: Optional[list[int]]
    wear: dict[str, float]
    out: str
    test: Optional[float]

    def __post_init__(self) -> None:
        self.made: list[Row] = []
        self.failed: list[Row] = []
        self.problems: list[Diagnostic] = []
        self._names: set[str] = set()
        self.seed = int(self.options.get("seed", 1))

    def take(self, file: File) -> None:
        """Makes a model of a file; what keeps it from being made is told, and the others go on."""
        try:
            content = file.read()
            self._write(file.path, content, *self._model(content, self._name(file.path)))
        except OSError as error:
            self._fail(file.path, why_unread(error))
        except (NotWritten, ValueError) as error:
            self._fail(file.path, str(error))
        except BaseException as error:
            if not (isinstance(error, MemoryError) or type(error).__name__ == "PanicException"):
                raise
            self._fail(file.path, "the reader of STEP ran out of memory, or failed, on this file")

    def _fail(self, path: str, reason: str) -> None:
        self.failed.append({"source": path, "reason": reason})
        self.problems.append(unusable(path, reason))

    def _model(self, content: bytes, name: str) -> tuple[Model, Row]:
        cloud, truth, report = _engine.import_step(name, content, **self.options, bodies=self.bodies)
        model = Model(cloud, None if truth is None else Segmentation(truth, cloud), name=name)
        if not self.wear:
            return model, report
        # As its files say it: a vector that is written is what is read again.
        texts = texts_of(model)
        given = [(role, role, None, None, len(text), text.encode, None) for role, text in texts.items()]
        again = _engine.read(name, given)
        left = None if again["truth"] is None else Segmentation(again["truth"], again["cloud"])
        return Model(again["cloud"], left, name=name).degraded(**self.wear, seed=self.seed), report

    def _write(self, source: str, content: bytes, model: Model, report: Row) -> None:
        folder = set_of(model.name, self.seed, self.test)
        texts, files = texts_of(model), {}
        for role in (each for each in names("roles") if each in texts):
            path = os.path.normpath(os.path.join(folder, _engine.path_of("beside", model.name, role)))
            write_file(os.path.normpath(os.path.join(self.out, path)), texts[role])
            files[path] = hashlib.sha256(texts[role].encode()).hexdigest()
        types = {} if model.truth is None else model.truth.types
        counts = {"points": len(model), "primitives": sum(types.values()), "types": types}
        whence = {"source": source, "sha256": hashlib.sha256(content).hexdigest()}
        self.made.append({"model": model.name, **whence, **counts, "files": files, "report": report})
        self.problems += [unusable(source, text, severity="warning") for text in report["doubts"]]

    def _name(self, path: str) -> str:
        """The name of the file, made one that no model before has."""
        own = _engine.file_name(name_of_part(path))
        name, at = own, 2
        while name.lower() in self._names:
            name, at = f"{own}-{at}", at + 1
        self._names.add(name.lower())
        return name


def _table(made: Sequence[Row]) -> str:
    if not made:
        return ""
    rows = [["model", "points", "primitives", "bodies", "faces", "left out", "diagonal, mm", "spacing, mm"]]
    for each in made:
        report = each["report"]
        counts = (each["points"], each["primitives"], report["bodies"], len(report["faces"]), report["lost"])
        rows.append([each["model"], *map(str, counts), precise(report["diagonal"], 4), precise(report["spacing"], 3)])
    return f"{align(rows, 1)}\n"
