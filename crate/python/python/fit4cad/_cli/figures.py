"""Numbers, names and rows as text, digit for digit as the other command line writes them."""

from __future__ import annotations

import json
import math
import re
from decimal import ROUND_HALF_UP, Context, Decimal
from typing import Any, Optional, Sequence

Value = Optional[float]

#: What moves a terminal's cursor or changes its colours; tabs and line ends stay.
_CONTROL = re.compile("[\x00-\x08\x0b-\x1f\x7f-\x9f]")
#: What ends a row, a comment or a cell.
_ENDING = re.compile("[\x00-\x1f\x7f-\x9f\u2028\u2029]")

#: JavaScript turns to powers of ten from here on, and below.
_LARGE, _SMALL = 1e21, 1e-6
#: Enough digits for the exact value of any number.
_EXACT = Context(prec=800, rounding=ROUND_HALF_UP)


def shown(value: float) -> str:
    """The shortest digits that tell the number from any other, as JavaScript writes it."""
    if isinstance(value, int):
        return str(value)
    if value == 0:
        return "0"
    sign, digits, exponent = Decimal(repr(value)).normalize().as_tuple()
    text = "".join(map(str, digits))
    assert isinstance(exponent, int)
    power = len(text) + exponent
    head = "-" if sign else ""
    if not _SMALL <= abs(value) < _LARGE:
        return head + text[0] + (f".{text[1:]}" if len(text) > 1 else "") + f"e{power - 1:+d}"
    if exponent >= 0:
        return head + text + "0" * exponent
    if power > 0:
        return f"{head}{text[:power]}.{text[power:]}"
    return f"{head}0.{'0' * -power}{text}"


def fixed(value: float, decimals: int) -> str:
    """With so many digits after the point; halves go up."""
    return format(Decimal(value if value else 0).quantize(Decimal(1).scaleb(-decimals), context=_EXACT), "f")


def scientific(value: float, decimals: int) -> str:
    """As a power of ten, with so many digits after the point."""
    if value == 0:
        return f"{fixed(0.0, decimals)}e+0"
    digits, power = _rounded(value, decimals + 1)
    return ("-" if value < 0 else "") + digits[0] + (f".{digits[1:]}" if decimals else "") + f"e{power:+d}"


def precise(value: float, digits: int) -> str:
    """With so many digits that count."""
    if value == 0:
        return fixed(0.0, digits - 1)
    text, power = _rounded(value, digits)
    if not -6 <= power < digits:
        return scientific(value, digits - 1)
    head = "-" if value < 0 else ""
    if power < 0:
        return f"{head}0.{'0' * (-power - 1)}{text}"
    return head + text[: power + 1] + (f".{text[power + 1 :]}" if power + 1 < digits else "")


def _rounded(value: float, digits: int) -> tuple[str, int]:
    found = Context(prec=digits, rounding=ROUND_HALF_UP).plus(Decimal(abs(value)))
    _, all_digits, exponent = found.as_tuple()
    assert isinstance(exponent, int)
    text = "".join(map(str, all_digits))
    return text.ljust(digits, "0"), len(text) + exponent - 1


def figure(value: Value, decimals: int = 4) -> str:
    """A figure of a table."""
    return "n/a" if value is None else fixed(value, decimals)


def share(value: Value) -> str:
    """A share in per cent."""
    return "n/a" if value is None else f"{fixed(value * 100, 1)} %"


def printable(text: str) -> str:
    """Without the control characters that files may have smuggled in."""
    return _CONTROL.sub("\ufffd", text)


def one_line(text: str) -> str:
    """In one line: nothing in it ends a row, a comment or a cell."""
    return _ENDING.sub("\ufffd", text)


def align(rows: Sequence[Sequence[str]], text_columns: int) -> str:
    """Rows of cells as lines: the first columns to the left, figures to the right."""
    clean = [[one_line(cell) for cell in row] for row in rows]
    widths = [max(map(_units, column)) for column in zip(*clean)]
    lines = []
    for row in clean:
        cells = (
            cell + " " * (width - _units(cell)) if at < text_columns else " " * (width - _units(cell)) + cell
            for at, (cell, width) in enumerate(zip(row, widths))
        )
        lines.append("  ".join(cells).rstrip())
    return "\n".join(lines)


def _units(text: str) -> int:
    """Its length as JavaScript counts it: characters beyond the first plane are two."""
    return len(text) + sum(character > "\uffff" for character in text)


def json_text(value: Any) -> str:
    """JSON with an indent of two, and a line end."""
    return f"{_json(value, '')}\n"


def _json(value: Any, indent: str) -> str:
    if isinstance(value, float):
        return shown(value) if math.isfinite(value) else "null"
    if not isinstance(value, (dict, list, tuple)):
        return json.dumps(value, ensure_ascii=False)
    deeper = f"{indent}  "
    if isinstance(value, dict):
        inside = [f"{json.dumps(key, ensure_ascii=False)}: {_json(each, deeper)}" for key, each in value.items()]
        first, last = "{}"
    else:
        inside = [_json(each, deeper) for each in value]
        first, last = "[]"
    if not inside:
        return first + last
    joined = f",\n{deeper}".join(inside)
    return f"{first}\n{deeper}{joined}\n{indent}{last}"
