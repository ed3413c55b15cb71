"""Reading the arguments of a command, with the words that Node has for what is wrong with them."""

from __future__ import annotations

import math
import os
import re
from dataclasses import dataclass
from typing import Any, Mapping, Optional, Sequence

from .figures import shown


class UsageError(Exception):
    """The command was called wrongly; the message says how, the exit code is 2."""


@dataclass(frozen=True)
class Option:
    """An option of a command; a flag where it takes no ``value``."""

    name: str
    words: str
    value: Optional[str] = "N"
    many: bool = False


def declared_option(info: Mapping[str, Any]) -> Option:
    """The option of a number that the engine declares, with the values it takes."""
    whole, unit = "whole number, " if info["whole"] else "", f" {info['unit']}" if info["unit"] else ""
    span = f"{shown(info['minimum'])} to {shown(info['maximum'])}{unit}, default {shown(info['default'])}"
    said = f"{whole}{span}"
    return Option(info["name"].replace("_", "-"), f"{info['explanation']} {said[0].upper()}{said[1:]}.")


#: A number as it is written on a command line.
_NUMBER = re.compile(r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?")

#: The options of a command that prints results.
FORMATS = (
    Option("format", "in what form results are printed", "FORMAT"),
    Option("json", "short for --format json", None),
)

JOBS = Option("jobs", "works on N models at once, 0 for as many as there are cores; the answers are the same")

#: More threads than any machine has use for.
MOST_JOBS = 256


def read_arguments(args: Sequence[str], options: Sequence[Option]) -> tuple[dict[str, Any], list[str]]:
    """The values of the options by name (``None``, ``False`` or ``[]`` where one was not given), and what else there is."""
    known = {option.name: option for option in options}
    values: dict[str, Any] = {each.name: [] if each.many else False if each.value is None else None for each in options}
    others: list[str] = []
    waiting = list(args)
    while waiting:
        argument = waiting.pop(0)
        if argument == "--":
            return values, others + waiting
        if not argument.startswith("-") or argument == "-":
            others.append(argument)
            continue
        flag, equal, value = argument.partition("=")
        option = known.get(flag[2:]) if flag.startswith("--") else None
        if option is None:
            raise UsageError(f"Unknown option '{flag if flag.startswith('--') else argument[:2]}'")
        if option.value is None:
            if equal:
                raise UsageError(f"Option '{flag}' does not take an argument")
            values[option.name] = True
            continue
        if not equal:
            value = _following(flag, waiting)
        if option.many:
            values[option.name].append(value)
        else:
            values[option.name] = value
    return values, others


def _following(flag: str, waiting: list[str]) -> str:
    if not waiting:
        raise UsageError(f"Option '{flag} <value>' argument missing")
    # A number that starts with a minus sign is a value.
    if len(waiting[0]) > 1 and waiting[0].startswith("-") and not re.match(r"-\.?\d", waiting[0]):
        raise UsageError(
            f"Option '{flag}' argument is ambiguous.\nDid you forget to specify the option argument for '{flag}'?\n"
            f"To specify an option argument starting with a dash use '{flag}=-XYZ'."
        )
    return waiting.pop(0)


def choice(option: str, value: str, allowed: Sequence[str]) -> str:
    """One of the allowed words."""
    if value not in allowed:
        raise UsageError(f"--{option} {value}: expected {', '.join(allowed)}")
    return value


def named(option: str, listed: str, allowed: Sequence[str]) -> list[str]:
    """The names of a list with commas, each allowed."""
    return [choice(option, name.strip(), allowed) for name in listed.split(",")]


def number(
    option: str, value: Optional[str], *, least: float = -math.inf, most: float = math.inf, whole: bool = False
) -> Optional[float]:
    """A number from ``least`` to ``most``, or ``None`` where the option was not given."""
    if value is None:
        return None
    parsed = float(value) if _NUMBER.fullmatch(value.strip()) else math.nan
    if not least <= parsed <= most or (whole and not (parsed.is_integer() and abs(parsed) < 2**53)):
        kind = "a whole number" if whole else "a number"
        span = f"of at least {shown(least)}" if most == math.inf else f"from {shown(least)} to {shown(most)}"
        raise UsageError(f"--{option} {value}: expected {kind} {span}")
    return int(parsed) if whole else parsed


def numbers_of(declared: Sequence[Mapping[str, Any]], given: Mapping[str, Any]) -> dict[str, float]:
    """The numbers given for options that the engine declares with their ranges, by name."""
    found = {}
    for info in declared:
        name = info["name"]
        value = number(name, given[name], least=info["minimum"], most=info["maximum"], whole=info["whole"])
        if value is not None:
            found[name] = value
    return found


def format_of(values: Mapping[str, Any], allowed: Sequence[str]) -> str:
    """The format asked for: the table where none was; ``--json`` is short for ``--format json``."""
    said = values["format"]
    if values["json"] and said not in (None, "json"):
        raise UsageError(f"--json and --format {said}: expected one format")
    return choice("format", "json" if values["json"] else said or "table", allowed)


def asks_for_json(args: Sequence[str]) -> bool:
    """Whether JSON is asked for by arguments that need not make sense otherwise."""
    own = list(args[: args.index("--")] if "--" in args else args)
    return any(
        each in ("--json", "--format=json") or (each == "json" and at > 0 and own[at - 1] == "--format")
        for at, each in enumerate(own)
    )


def jobs_of(values: Mapping[str, Any]) -> int:
    """How many models are worked on at once."""
    given = number("jobs", values["jobs"], least=0, most=MOST_JOBS, whole=True)
    if given is None:
        return 1
    return int(given) or min(os.cpu_count() or 1, MOST_JOBS)


def some(paths: Sequence[str], wanted: str = "give at least one file, folder or zip") -> Sequence[str]:
    """The paths, of which there has to be one."""
    if not paths:
        raise UsageError(wanted)
    return paths
