"""``fit4cad score``."""

from __future__ import annotations

import hashlib
from dataclasses import dataclass
from typing import Any, Callable, Optional, Sequence

from .. import _engine
from .._declared import declared, names
from .._errors import Diagnostic
from .._files import Group, unusable
from .._model import Model
from .arguments import FORMATS, JOBS, Option, choice, format_of, jobs_of, read_arguments, some
from .field import OPTIONS as FIELD
from .field import Field, field_of, score_field
from .formats import BOLD, TABLES, WRITERS
from .lines import OPTIONS as SHOWN
from .lines import are_columns, refuse_beside_field, wanted_of
from .models import AS, Hear, Overrides, corrections, each_model, found, of_truth
from .published import with_published
from .terminal import clear, print_text, tell, warn

Row = dict[str, Any]

OPTIONS = (
    Option("protocol", "by what rules; see below", "NAME"),
    *FIELD,
    *SHOWN,
    *FORMATS,
    Option("self", "scores the truth against itself, as method “truth”", None),
    JOBS,
    AS,
)

USAGE = (
    "PATH… [--protocol NAME,NAME…] [--measures NAME,NAME…] [--by NAME,NAME…] [--format FORMAT] [--means] [--digits N] "
    "[--bold] [--published] [--self] [--jobs N]"
)
WORDS = "Scores every submission found in the given files, folders and zips against the ground truth found beside it."
NOT_PUBLISHED = "fit4cad score: --published adds nothing: no model is one of the 35 test models, by name, points and true primitives."
NOTHING = "fit4cad score: nothing could be scored. A score needs a cloud, its truth and a submission; see fit4cad score --help."


def more() -> list[tuple[str, list[tuple[str, str]]]]:
    """What the help lists besides the options."""
    figures = declared()["figures"]
    told = declared()["recognition"]
    return [
        ("Protocols", [(each["name"], each["meaning"]) for each in declared()["protocols"]]
            + [(each["key"], f"{each['title']}. {each['definition']} Trap: {each['trap']}") for each in figures if each["group"] == "segmentation"]
            + [(told["key"], f"{told['title']}. {told['definition']} Trap: {told['trap']}"), ("all", "all of the field, without the tables of segments")]),
        ("Measures", [(each["key"], f"{each['name']}, {each['range']}; {each['better']} is better. {each['meaning']}") for each in declared()["measures"]]),
        ("--measures NAME,NAME… (or all)", [(each["key"], f"{each['title']}; {each['better']} is better. {each['definition']}") for each in figures if each["group"] == "fit"]),
        ("--normalisation NAME", [(each["name"], each["meaning"]) for each in declared()["normalisations"]]),
        ("--by NAME,NAME…", [(each["name"], f"{each['title']}. {each['how']}") for each in declared()["strata"]]),
        ("Files of a model, by their names", [(each["name"], each["meaning"]) for each in declared()["roles"]]),
        ("Formats", [(name, what) for name, (what, _) in WRITERS.items()]),
    ]  # fmt: skip


@dataclass
class Evaluated:
    """What became of one model: its results, what is told of it, and which of that the results tell themselves."""

    results: list[Row]
    problems: list[Diagnostic]


def score(args: Sequence[str]) -> int:
    """Scores what the arguments name; gives the exit code."""
    values, paths = read_arguments(args, OPTIONS)
    some(paths)
    values["protocol"] = values["protocol"] or names("protocols")[0]
    field = field_of({**values, "measures": None} if are_columns(values) else values)
    form = format_of(values, list(WRITERS))
    if field is not None:
        refuse_beside_field(values)
    wanted = wanted_of({**values, "measures": None} if field is not None else values, form, TABLES, BOLD)
    jobs = jobs_of(values)
    if field is None:
        protocol = choice("protocol", values["protocol"], names("protocols"))
    files, problems = found(paths)
    overrides = corrections(values["as"], files)

    def evaluate(report: Callable[[Model, Optional[str]], Row]) -> list[Row]:
        results, told = evaluated(files, report, overrides=overrides, itself=values["self"], jobs=jobs)
        problems.extend(told)
        return results

    if field is not None:
        return score_field(evaluate, files, problems, field, form)
    results = evaluate(lambda model, method: model.score(method, protocol).to_dict())
    clear()
    if form == "json":
        # Its reports hold their own diagnostics; only the others are left for the terminal.
        shown = {str(Diagnostic(**each)) for result in results for each in result["diagnostics"]}
        failed = tell_besides(problems, shown)
    else:
        failed = tell(problems)
    if not results:
        warn(NOTHING)
    rows = with_published(results) if values["published"] else results
    if values["published"] and len(rows) == len(results):
        warn(NOT_PUBLISHED)
    scores = [(each["method"], each["mean"], each["type_errors"] or 0) for each in rows]
    print_text(WRITERS[form][1](rows, _engine.summarise(scores), wanted))
    return 1 if failed or not results else 0


def tell_besides(problems: list[Diagnostic], shown: set[str]) -> bool:
    """Tells those that are not shown; gives whether any is an error."""
    tell(each for each in problems if str(each) not in shown)
    return any(each.severity == "error" for each in problems)


def evaluated(
    files: list[Any],
    report: Callable[[Model, Optional[str]], Row],
    *,
    overrides: Overrides,
    itself: bool,
    jobs: int,
) -> tuple[list[Row], list[Diagnostic]]:
    """What ``report`` says of every submission, each with the engine's version and the files it was made of."""

    def visit(group: Group, hear: Hear) -> Evaluated:
        sums: dict[str, Any] = {}

        def hash_of(path: str, content: bytes) -> None:
            sums.setdefault(path, hashlib.sha256()).update(content)

        model = group.read(of_truth, hash_of) if itself else group.read(hear=hash_of)
        told = model.diagnostics
        if model.truth is None:
            hint = f"Give {model.name}_primitives.txt of the benchmark as well"
            return Evaluated([], [*told, unusable(model.name, "there is no ground truth to score against", hint)])
        if not itself and not model.submissions:
            hint = (
                "Give a method's files in a folder named after it (pointCloud_primitives_MINE), or score the truth "
                "against itself with --self"
            )
            return Evaluated([], [*told, unusable(model.name, "there is no submission to score", hint, "note")])
        listed: list[Row] = []
        for placed in group.files:
            if placed.file.path in sums:
                whose = {} if placed.method is None else {"method": placed.method}
                listed.append({"path": placed.file.path, "role": placed.role, **whose, "sha256": sums[placed.file.path].hexdigest()})
        results = []
        for method in [None] if itself else list(model.submissions):
            said = report(model, method)
            own = [each for each in listed if each.get("method") in (None, said["method"])]
            results.append({**said, "engine": _engine.__version__, "files": own})
        return Evaluated(results, told)

    models, unplaced, stops = each_model(files, visit, "scoring", overrides=overrides, jobs=jobs)
    problems = [*unplaced, *stops, *(problem for each in models for problem in each.problems)]
    return [result for each in models for result in each.results], problems
