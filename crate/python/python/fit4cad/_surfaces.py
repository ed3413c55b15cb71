"""The five families of surfaces in canonical form, in the coordinates and units of their cloud."""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import Any, ClassVar, Optional, Union

import numpy as np
import numpy.typing as npt

from . import _engine

Triple = tuple[float, float, float]


def _camel(name: str) -> str:
    head, *rest = name.split("_")
    return head + "".join(word.capitalize() for word in rest)


class _Surface:
    type: ClassVar[str]

    def to_dict(self) -> dict[str, Any]:
        """With the keys of the command line's JSON."""
        own = {_camel(each.name): getattr(self, each.name) for each in fields(self)}  # type: ignore[arg-type]
        return {"type": self.type, **{key: list(it) if isinstance(it, tuple) else it for key, it in own.items()}}

    def distance(self, points: npt.ArrayLike) -> npt.NDArray[np.float64]:
        """The distance of each of the points, shape (n, 3), from the whole surface."""
        array = np.ascontiguousarray(points, dtype=np.float64).reshape(-1, 3)
        return _engine.distances(_engine.Cloud(array), self.to_dict())


@dataclass(frozen=True)
class Plane(_Surface):
    """The points x with normal·x = offset; the normal has length 1."""

    type: ClassVar[str] = "Plane"
    normal: Triple
    offset: float


@dataclass(frozen=True)
class Cylinder(_Surface):
    """The points at one distance from the line through ``centre`` along ``axis``, without end."""

    type: ClassVar[str] = "Cylinder"
    centre: Triple
    axis: Triple
    radius: float


@dataclass(frozen=True)
class Cone(_Surface):
    """The points whose direction from the apex makes one angle with the axis, both nappes; radians."""

    type: ClassVar[str] = "Cone"
    apex: Triple
    axis: Triple
    half_angle: float


@dataclass(frozen=True)
class Sphere(_Surface):
    """The points at one distance from a centre."""

    type: ClassVar[str] = "Sphere"
    centre: Triple
    radius: float


@dataclass(frozen=True)
class Torus(_Surface):
    """The points at ``minor_radius`` from a circle of ``major_radius`` about ``centre``, across ``axis``."""

    type: ClassVar[str] = "Torus"
    centre: Triple
    axis: Triple
    major_radius: float
    minor_radius: float


@dataclass(frozen=True)
class StandardErrors:
    """How far the parameters of a surface may be off by chance alone, as its points show them.

    Of the axis or a plane's normal an angle, in radians; of the position a distance: of a centre or apex, or across a
    cylinder's axis or a plane at the middle of the points; of a plane's offset from the origin; of the radius (of a torus
    the major one), a torus's minor radius, and a cone's half-angle, in radians. ``None`` where the surface has no such parameter, or
    the points do not determine it.
    """

    axis: Optional[float] = None
    position: Optional[float] = None
    offset: Optional[float] = None
    radius: Optional[float] = None
    minor_radius: Optional[float] = None
    half_angle: Optional[float] = None

    def to_dict(self) -> dict[str, Optional[float]]:
        """With the keys of the command line's JSON."""
        return {_camel(each.name): getattr(self, each.name) for each in fields(self)}


def errors_from(dict: dict[str, Optional[float]]) -> StandardErrors:
    """The standard errors of a dictionary as the engine and the command line's JSON have it."""
    return StandardErrors(**{each.name: dict[_camel(each.name)] for each in fields(StandardErrors)})


Surface = Union[Plane, Cylinder, Cone, Sphere, Torus]

_FAMILIES = {family.type: family for family in (Plane, Cylinder, Cone, Sphere, Torus)}


def surface_from(dict: dict[str, Any]) -> Surface:
    """The surface of a dictionary as the engine and the command line's JSON have it."""
    family = _FAMILIES[dict["type"]]
    own = {each.name: dict[_camel(each.name)] for each in fields(family)}
    values: Any = {name: tuple(it) if isinstance(it, (list, tuple)) else it for name, it in own.items()}
    return family(**values)


def surface_of(type: str, values: npt.ArrayLike, form: str = "parametric") -> tuple[Surface, float]:
    """The surface nearest to a vector in the paper's ``parametric`` or ``implicit`` form.

    Gives the surface and its misfit: how far apart the two are, as a share of the surface's size; rounding for a
    vector that is a surface of its type. Raises ``ValueError`` where the vector has another length than its type
    asks for or no member of the family is near (Romanengo et al. 2022, appendix).
    """
    vector = np.asarray(values, dtype=np.float64).ravel().tolist()
    found, misfit = _engine.surface_of(form, type, vector)
    return surface_from(found), misfit
