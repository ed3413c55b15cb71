"""Colours of segments: those of the page and of what the command line exports."""

from __future__ import annotations

from ._colours import SEGMENT_COLOURS, UNSEGMENTED
from ._declared import declared


def rgb(colour: str) -> tuple[int, int, int]:
    """Red, green and blue, 0 to 255, of ``#rrggbb``."""
    return int(colour[1:3], 16), int(colour[3:5], 16), int(colour[5:7], 16)


#: Red, green and blue of points of no segment, then of the segments.
SEGMENTS = [rgb(colour) for colour in (UNSEGMENTED, *SEGMENT_COLOURS)]


def TYPES() -> list[tuple[int, int, int]]:
    """Red, green and blue of each type, in the order of the declared types."""
    return [rgb(SEGMENT_COLOURS[each["colour"]]) for each in declared()["surfaceTypes"]]
