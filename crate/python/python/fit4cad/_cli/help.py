"""What ``--help`` teaches: the options of the commands, and what the engine declares."""

from __future__ import annotations

from typing import Iterable, Sequence

from .arguments import Option
from .main import COMMANDS, ELSEWHERE, module_of

_WIDTH = 98
_INDENT = 2
_COLUMN = 26


def help_on(topic: str) -> str:
    """The help on a command, or on all."""
    return _all() if topic == "fit4cad" else _one(topic)


def _all() -> str:
    entries = [(f"fit4cad {name}", module_of(name).WORDS.split(". ")[0].split(":")[0].rstrip(".")) for name in COMMANDS]
    return f"""fit4cad: fit, score and make segmentations of CAD point clouds, as the Fit4CAD benchmark does

{_terms([*entries, ("fit4cad COMMAND --help", "what a command reads, prints and means"), ("fit4cad --version", "")])}
score, fit, import, check and stats print a table; with --format json, or --json for short, they print all
they know, for programs, and {{"error": …}} where a call fails as a whole.
{" and ".join(ELSEWHERE)} are commands of npx fit4cad alone: they keep a checkout's standing table.

Exit code: 0 all well, 1 some input was unusable (the rest was done), 2 called wrongly.
"""


def _one(name: str) -> str:
    module = module_of(name)
    options: Sequence[Option] = module.options() if hasattr(module, "options") else module.OPTIONS
    entries = [(f"--{each.name}{f' {each.value}' if each.value else ''}", each.words) for each in options]
    parts = [f"fit4cad {name} {module.USAGE}\n", "\n".join(_wrapped(module.WORDS, _WIDTH)) + "\n", _terms(entries)]
    for title, listed in module.more() if hasattr(module, "more") else []:
        parts.append(f"{title}:\n{_terms(listed)}")
    return "\n".join([*parts, "Exit code: 0 all well, 1 some input unusable, 2 called wrongly.\n"])


def _terms(entries: Iterable[tuple[str, str]]) -> str:
    """Lines of words and their meanings, the meanings wrapped; a word too long for its column stands on a line of its own."""
    lines = []
    for word, meaning in entries:
        first, *others = _wrapped(meaning, _WIDTH - _COLUMN)
        head = " " * _INDENT + word
        lines += [head.ljust(_COLUMN) + first] if len(head) < _COLUMN - 1 else [head, " " * _COLUMN + first]
        lines += [" " * _COLUMN + line for line in others]
    return "".join(f"{line.rstrip()}\n" for line in lines)


def _wrapped(text: str, width: int) -> list[str]:
    lines = [""]
    for word in text.split(" "):
        if lines[-1] and len(lines[-1]) + 1 + len(word) > width:
            lines.append(word)
        else:
            lines[-1] = f"{lines[-1]} {word}" if lines[-1] else word
    return lines
