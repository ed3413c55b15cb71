"""What goes to the terminal: results to stdout, everything else to stderr."""

from __future__ import annotations

import contextlib
import os
import shutil
import sys
from typing import Any, Iterable, Iterator, Union

from .._errors import Diagnostic
from .._files import unusable, why_unwritten, write_whole
from .figures import printable

_showing = False


class NotPrinted(Exception):
    """Nothing more can be printed; the message says why."""

    def __init__(self, error: OSError) -> None:
        super().__init__(f"the result could not be printed: {why_unwritten(error)}")


def print_text(text: str) -> None:
    """Writes to stdout. Raises ``NotPrinted``, or ``BrokenPipeError`` where the reader of a pipe has gone."""
    try:
        _write(sys.stdout, text)
    except BrokenPipeError:
        raise
    except OSError as error:
        raise NotPrinted(error) from error


def _write(stream: Any, text: str) -> None:
    """In UTF-8 and with plain line ends, on every system: what is printed may be a file's content."""
    raw = getattr(stream, "buffer", None)
    if raw is None:
        stream.write(text)
    else:
        stream.flush()
        raw.write(text.encode("utf-8", "surrogateescape"))
    stream.flush()


def warn(text: str) -> None:
    """A line for the person at the terminal."""
    clear()
    with contextlib.suppress(OSError):
        _write(sys.stderr, f"{printable(text)}\n")


def progress(text: str) -> None:
    """One line that is rewritten in place, only where stderr is a terminal."""
    global _showing
    if sys.stderr.isatty():
        width = max(20, shutil.get_terminal_size().columns - 1)
        sys.stderr.write(f"\r\x1b[K{printable(text)[:width]}")
        sys.stderr.flush()
        _showing = True


def clear() -> None:
    """Takes that line away."""
    global _showing
    if _showing:
        sys.stderr.write("\r\x1b[K")
        _showing = False


def tell(problems: Iterable[Diagnostic]) -> bool:
    """Tells each in a line; gives whether one is an error."""
    wrong = False
    for problem in problems:
        warn(str(problem))
        wrong = wrong or problem.severity == "error"
    return wrong


class NotWritten(Exception):
    """A file could not be written; the message names it and says why."""

    def __init__(self, path: object, error: OSError) -> None:
        super().__init__(f"{path} could not be written: {why_unwritten(error)}")


def make_folder(path: str) -> None:
    """Makes a folder that files are to go to, if missing. Raises ``NotWritten``."""
    try:
        os.makedirs(path, exist_ok=True)
    except OSError as error:
        raise NotWritten(path, error) from error


def write_file(path: str, content: Union[str, bytes]) -> str:
    """Writes a file whole or not at all; gives its path. Raises ``NotWritten``."""
    try:
        write_whole(path, content)
    except OSError as error:
        raise NotWritten(path, error) from error
    return path


@contextlib.contextmanager
def telling(problems: list[Diagnostic], about: str) -> Iterator[None]:
    """Tells what keeps something from being written, and goes on."""
    try:
        yield
    except NotWritten as error:
        problems.append(unusable(about, str(error)))


