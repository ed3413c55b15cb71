"""``fit4cad generate``."""

from __future__ import annotations

import re
from typing import Optional, Sequence

from .. import _engine
from .._api import generate as generated
from .._declared import declared, names
from .._files import texts_of
from .arguments import Option, UsageError, declared_option, numbers_of, read_arguments
from .models import below
from .terminal import print_text, write_file

USAGE = "PART [options] [--imperfect] [--name NAME] [--out DIR], or --list"
WORDS = "Makes a CAD-like part with its ground truth: the files of a Fit4CAD model. The same options always give the same files."


def options() -> Sequence[Option]:
    """The options, with those of the engine."""
    return (
        Option("list", "the parts, with what each is good for", None),
        *map(declared_option, declared()["sampleOptions"]),
        Option("imperfect", "also a submission that is wrong in common ways, so that there is something to score", None),
        Option("name", "what the model is called (default: as its part)", "NAME"),
        Option("out", "where the files go (default: the current folder); made if missing", "DIR"),
    )


def generate(args: Sequence[str]) -> int:
    """Makes a part's files, or lists the parts; gives the exit code."""
    values, others = read_arguments(args, options())
    given = numbers_of(declared()["sampleOptions"], values)
    if values["list"]:
        if others:
            raise UsageError("--list takes no part")
        width = max(map(len, names("parts")))
        print_text("".join(f"{part['name'].ljust(width)}  {part['description']}\n" for part in declared()["parts"]))
        return 0
    if len(others) != 1:
        raise UsageError("give one part; --list shows them")
    [part] = others
    if part not in names("parts"):
        raise UsageError(f'there is no part "{part}"; --list shows what there is')
    name = part if values["name"] is None else values["name"]
    if not re.fullmatch(r"[^/\\]+", name):
        raise UsageError(f"--name {name}: expected a name of files, without folders")
    try:
        model = generated(part, name=name, **given)
    except ValueError as error:
        # The engine says what is wrong with the options (a spacing of a millionth, say).
        raise UsageError(str(error)) from error
    methods: list[Optional[str]] = [None]
    if values["imperfect"]:
        methods.append(model.imperfect(int(given.get("seed", 1))))
    written = []
    for method in methods:
        texts = texts_of(model, method)
        for role in (each for each in names("roles") if each in texts):
            path = _engine.path_of("beside", name, role, method)
            written.append(write_file(below(values["out"] or ".", path), texts[role]))
    print_text("".join(f"{path}\n" for path in written))
    return 0
