"""Finds the command, and turns failures into exit codes: 0 all well, 1 some input unusable, 2 called wrongly."""

from __future__ import annotations

import os
import sys
from importlib import import_module
from typing import Any, Callable, Optional, Sequence

from .. import _engine
from .._errors import InputError
from .arguments import UsageError, asks_for_json
from .figures import json_text
from .terminal import NotPrinted, NotWritten, print_text, warn

#: By its name, the module of a command and what in it runs it.
COMMANDS = {
    "score": ("score", "score"),
    "fit": ("fit", "fit"),
    "export": ("export", "export"),
    "import": ("import_parts", "import_parts"),
    "check": ("check", "check"),
    "stats": ("stats", "stats"),
    "generate": ("generate", "generate"),
    "degrade": ("degrade", "degrade"),
}
#: Commands of the other command line alone.
ELSEWHERE = ("submit", "verify")

_USAGE, _FAILED, _INTERRUPTED = 2, 1, 130


def module_of(name: str) -> Any:
    """The module of a command, loaded when it is asked for."""
    return import_module(f".{COMMANDS[name][0]}", __package__)


def main(args: Sequence[str]) -> int:
    """Runs the command line; gives the exit code."""
    try:
        return _run(list(args))
    except BrokenPipeError:
        # The reader has gone (`fit4cad … | head`).
        _be_silent()
        return 0
    except NotPrinted as error:
        warn(f"fit4cad: {error}")
        _be_silent()
        return _FAILED
    except KeyboardInterrupt:
        return _INTERRUPTED


def _be_silent() -> None:
    """Nothing more is to be said on stdout, at the end neither."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def _run(args: list[str]) -> int:
    if not args:
        warn(_help("fit4cad").rstrip("\n"))
        return _USAGE
    name, *rest = args
    if name in ("help", "--help", "-h"):
        topic = rest[0] if rest else "fit4cad"
        return _shown(topic) if topic == "fit4cad" or topic in COMMANDS else _unknown(topic, rest)
    if name in ("--version", "-V"):
        print_text(f"fit4cad {_engine.__version__}\n")
        return 0
    if name not in COMMANDS:
        return _unknown(name, rest)
    if "--help" in rest or "-h" in rest:
        return _shown(name)
    return _attempt(name, rest, getattr(module_of(name), COMMANDS[name][1]))


def _attempt(name: str, args: Sequence[str], run: Callable[[Sequence[str]], int]) -> int:
    """Runs a command; a failure is said in the terminal, and in the result where JSON is asked for."""
    who = f"fit4cad {name}"
    try:
        return run(args)
    except UsageError as error:
        return _fail(who, args, _USAGE, str(error), f"Try fit4cad {name} --help.")
    except (NotWritten, InputError) as error:
        return _fail(who, args, _FAILED, str(error))


def _fail(who: str, args: Sequence[str], code: int, message: str, advice: Optional[str] = None) -> int:
    warn(f"{who}: {message}")
    if advice is not None:
        warn(advice)
    if asks_for_json(args):
        print_text(json_text({"error": message}))
    return code


def _unknown(name: str, args: Sequence[str]) -> int:
    if name in ELSEWHERE:
        return _fail("fit4cad", args, _USAGE, f'"{name}" is a command of npx fit4cad alone, which has the standing table beside it.')
    listed = ", ".join(COMMANDS)
    return _fail("fit4cad", args, _USAGE, f'there is no command "{name}". Commands: {listed}; try fit4cad --help.')


def _shown(topic: str) -> int:
    print_text(_help(topic))
    return 0


def _help(topic: str) -> str:
    from .help import help_on

    return help_on(topic)
