"""``fit4cad export``."""

from __future__ import annotations

from typing import Iterator, Sequence, Union

from .. import _engine
from .._declared import declared, names
from .._errors import Diagnostic
from .._files import Group, texts_of, unusable
from .._files import export as exported
from .._model import Model
from .._palette import TYPES
from .arguments import Option, UsageError, choice, read_arguments, some
from .models import AS, Hear, below, corrections, each_model, found
from .terminal import clear, make_folder, print_text, tell, telling, warn, write_file

#: The benchmark's own files, which are several.
_OWN = "fit4cad"
#: Surfaces for CAD, which the reader of STEP writes.
_STEP = "step"
#: What the truth is called among methods.
_TRUTH = "truth"

USAGE = "PATH… --to FORM[,FORM…] [--method NAME] [--out DIR] [--as …]"
WORDS = "Writes the truth and every submission found in the given files, folders and zips in other forms, with or without a truth beside them."
OPTIONS = (
    Option("to", "in which forms", "FORM,FORM…", many=True),
    Option("method", "only of that method; truth for the ground truth", "NAME"),
    Option("out", "where the files go (default: the current folder); made if missing", "DIR"),
    AS,
)


def more() -> list[tuple[str, list[tuple[str, str]]]]:
    """What the help lists besides the options."""
    forms = [(each["name"], f"{each['title']}. {each['meaning']}") for each in declared()["exports"]]
    return [("Forms", [*forms, (_STEP, "Surfaces, STEP."), (_OWN, "The benchmark's own four files.")])]


def export(args: Sequence[str]) -> int:
    """Writes the segmentations that the arguments name in the forms asked for; gives the exit code."""
    values, paths = read_arguments(args, OPTIONS)
    known = [*names("exports"), _STEP, _OWN]
    forms = [choice("to", form, known) for listed in values["to"] for form in listed.split(",")]
    if not forms:
        raise UsageError(f"choose a form: --to {', '.join(known)}")
    some(paths)
    out = values["out"] or "."
    make_folder(out)
    files, problems = found(paths)
    overrides = corrections(values["as"], files)
    written: list[str] = []

    def visit(group: Group, _: Hear) -> None:
        model = group.read()
        problems.extend(model.diagnostics)
        every = [*([] if model.truth is None else [_TRUTH]), *model.submissions]
        wanted = [called for called in every if values["method"] in (None, called)]
        if not wanted:
            hint = f"There is {', '.join(every) or 'none at all'}"
            problems.append(unusable(model.name, "there is no segmentation to export", hint))
        for called in wanted:
            for path, content in _files(model, called, forms, problems):
                with telling(problems, model.name):
                    written.append(write_file(below(out, path), content))

    _, unplaced, stops = each_model(files, visit, "exporting", overrides=overrides)
    clear()
    failed = tell([*problems, *unplaced, *stops])
    if not written:
        warn("fit4cad export: nothing was written. An export needs a cloud and segments of it; see fit4cad export --help.")
    print_text("".join(f"{path}\n" for path in written))
    return 1 if failed or not written else 0


def _files(model: Model, called: str, forms: Sequence[str], problems: list[Diagnostic]) -> Iterator[tuple[str, Union[str, bytes]]]:
    """The files of one segmentation, with their paths."""
    method = None if called == _TRUTH else called
    *folders, name = model.name.split("/")
    stem = "/".join(map(_engine.file_name, [*folders, f"{name}_{called}"]))
    endings = {each["name"]: each["ending"] for each in declared()["exports"]}
    for form in forms:
        if form in endings:
            yield stem + endings[form], exported(model, form, method)
        elif form == _STEP:
            text, left_out = _engine.export_step(model.name, model._cloud, model.segmentation(method)._native, TYPES())
            path = f"{stem}_surfaces.step"
            if left_out > 0:
                absence = f"{left_out} primitives are not in it: they have no surface, or too few points for an outline"
                problems.append(unusable(path, absence, severity="warning"))
            yield path, text
        else:
            texts = {"cloud": texts_of(model)["cloud"], **texts_of(model, method)}
            for role in (each for each in names("roles") if each in texts):
                yield _engine.path_of("test-set", model.name, role, None if role == "cloud" else method), texts[role]
