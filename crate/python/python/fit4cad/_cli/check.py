"""``fit4cad check``."""

from __future__ import annotations

from typing import Any, Optional, Sequence

from .. import _engine
from .._errors import Diagnostic
from .._files import Group, unusable
from .._results import Audit
from .arguments import FORMATS, Option, format_of, read_arguments, some
from .figures import align, json_text
from .models import Hear, below, each_model, found, of_truth
from .terminal import clear, make_folder, print_text, tell, telling, warn, write_file

Row = dict[str, Any]

USAGE = "PATH… [--format table|json] [--write DIR]"
WORDS = "Checks every ground truth found in the given files, folders and zips: its files, and the points, the parametric and the implicit form of each primitive against each other."
OPTIONS = (*FORMATS, Option("write", "folder that gets surface files with wrong vectors replaced by exact conversions", "DIR"))


def check(args: Sequence[str]) -> int:
    """Audits every ground truth that the arguments name; gives the exit code."""
    values, paths = read_arguments(args, OPTIONS)
    some(paths)
    form = format_of(values, ["table", "json"])
    files, problems = found(paths)
    writer = None if values["write"] is None else Writer(values["write"], problems)

    def visit(group: Group, _: Hear) -> Audit:
        model = group.read(of_truth)
        audit = model.check()
        if model.truth is None:
            hint = f"Give {model.name}_primitives.txt as well"
            problems.append(unusable(model.name, "there is no ground truth to check", hint))
        elif writer is not None:
            writer.write(model.name, audit)
        return audit

    audits, unplaced, stops = each_model(files, visit, "checking")
    clear()
    failed = tell([*problems, *unplaced, *stops])
    if not audits:
        warn("fit4cad check: nothing could be checked. A check needs a cloud and its truth; see fit4cad check --help.")
    for path, numbers in writer.written if writer else []:
        warn(f"wrote {path}: replaced the vectors of primitives {', '.join(map(str, numbers))}")
    if form == "json":
        print_text(json_text([{"engine": _engine.__version__, **audit.to_dict()} for audit in audits]))
    else:
        print_text(_table(audits))
    return 1 if failed or not audits or not all(audit.ok for audit in audits) else 0


class Writer:
    """Writes corrected surface files, each once, and remembers which."""

    def __init__(self, folder: str, problems: list[Diagnostic]) -> None:
        make_folder(folder)
        self.folder, self.problems = folder, problems
        self.written: list[tuple[str, list[int]]] = []
        self._paths: set[str] = set()

    def write(self, name: str, audit: Audit) -> None:
        """Writes what was corrected of a model."""
        for form, text in audit.corrected.items():
            path = below(self.folder, _engine.path_of("beside", name, form))
            if path in self._paths:
                message = "it was not written: two models have this name; check their folders one at a time"
                self.problems.append(unusable(path, message))
                continue
            self._paths.add(path)
            with telling(self.problems, path):
                write_file(path, text)
                self.written.append((path, [each["primitive"] for each in audit.corrections if each["form"] == form]))


def _table(audits: Sequence[Audit]) -> str:
    if not audits:
        return ""
    rows = [["model", "primitive", "severity", "check", "finding"]]
    for audit in audits:
        for each in audit.findings:
            said = each.message + (f". {each.hint}" if each.hint else "")
            rows.append([audit.model, _number(each.primitive), each.severity, each.check, said])
    lines = [align(rows, len(rows[0]))] if len(rows) > 1 else []
    every = [each.severity for audit in audits for each in audit.findings]
    counts = ", ".join(_counted(every.count(word), word) for word in ("error", "warning", "note"))
    primitives = sum(len(audit.primitives) for audit in audits)
    return "\n".join([*lines, f"{_counted(len(audits), 'model')}, {_counted(primitives, 'primitive')}: {counts}"]) + "\n"


def _number(number: Optional[int]) -> str:
    return "" if number is None else str(number)


def _counted(number: int, noun: str) -> str:
    return f"{number} {noun}{'' if number == 1 else 's'}"
