"""What is raised, and what is wrong with an input."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from . import _engine


@dataclass(frozen=True)
class Diagnostic:
    """One finding about an input: where, what was found, what was expected and what to do.

    ``severity`` is ``note``, ``warning`` or ``error``; ``line`` and ``column`` count from 1, the column in bytes,
    and are ``None`` where the finding is about the file as a whole. ``str()`` gives it in the one line that the
    command line prints.
    """

    severity: str
    file: str
    message: str
    found: str = ""
    expected: str = ""
    hint: str = ""
    line: int | None = None
    column: int | None = None

    def __str__(self) -> str:
        place = None if self.line is None or self.column is None else (self.line, self.column)
        texts = (self.found, self.expected, self.hint)
        return _engine.one_line(self.severity, self.file, place, self.message, *texts)

    def to_dict(self) -> dict[str, Any]:
        """With the keys of the command line's JSON, in its order."""
        place = {} if self.line is None else {"line": self.line, "column": self.column}
        head = {"severity": self.severity, "file": self.file, **place, "message": self.message}
        return {**head, "found": self.found, "expected": self.expected, "hint": self.hint}


class InputError(ValueError):
    """An input cannot be used. Says which file, where in it, what was found, what was expected and what to do.

    ``diagnostics`` holds every error of the input; the attributes are those of the first.
    """

    def __init__(self, *diagnostics: Diagnostic) -> None:
        self.diagnostics = diagnostics
        first = diagnostics[0]
        self.file, self.line, self.column = first.file, first.line, first.column
        self.message, self.hint = first.message, first.hint
        more = len(diagnostics) - 1
        super().__init__(f"{first}" + (f" (and {more} more, in .diagnostics)" if more else ""))

    def __reduce__(self) -> tuple[Any, ...]:
        return (InputError, self.diagnostics)
