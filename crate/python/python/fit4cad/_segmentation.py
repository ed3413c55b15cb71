"""Points grouped into primitives."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Iterator, Optional, Sequence, Union

import numpy as np
import numpy.typing as npt

from . import _engine
from ._surfaces import StandardErrors, Surface, errors_from, surface_from
from ._tables import Row, Table

ByLabel = Union[Sequence[Any], Mapping[int, Any], None]


@dataclass(frozen=True)
class Primitive:
    """A group of points and the surface they lie on.

    ``points`` are indices into the cloud, from 0, ascending, ``uint32``; ``type`` is ``None`` where it is none of
    the five; ``parametric`` and ``implicit`` are the paper's vectors, ``None`` where there is none; ``mfe`` is the
    mean distance of the points to the surface over the diagonal of their box; ``standard_errors`` say how sure the surface
    is by its points.
    """

    number: int
    points: npt.NDArray[np.uint32]
    type: Optional[str] = None
    surface: Optional[Surface] = None
    parametric: Optional[npt.NDArray[np.float64]] = None
    implicit: Optional[npt.NDArray[np.float64]] = None
    mfe: Optional[float] = None
    standard_errors: StandardErrors = StandardErrors()

    def __len__(self) -> int:
        return len(self.points)


@dataclass(frozen=True)
class Noise:
    """The noise that a fit went by.

    ``deviation`` is the standard deviation of the points off their surfaces, in the units of the cloud, 0 where none could be
    told; ``source`` is ``given``, ``measured``, or ``tolerance`` where it follows from one that was given; ``kind`` is ``exact``,
    ``scattered``, ``rounded`` (to ``step``), ``mixed`` or ``everywhere`` (the points are on no surfaces), ``None`` where it is not known.
    """

    deviation: float
    source: str
    kind: Optional[str]
    step: float


class Segmentation(Table, Sequence[Primitive]):
    """The primitives of a cloud, in the order of their file or as a fitter found them, largest first.

    Primitives may share points (usually along edges), and points of none are unsegmented. A segmentation does not
    change; it is a sequence of :class:`Primitive`.
    """

    def __init__(self, native: _engine.Segmentation, cloud: _engine.Cloud) -> None:
        self._native, self._cloud = native, cloud
        self._primitives: Optional[tuple[Primitive, ...]] = None

    @classmethod
    def from_labels(
        cls, points: npt.ArrayLike, labels: npt.ArrayLike, types: ByLabel = None, surfaces: ByLabel = None
    ) -> Segmentation:
        """The segments that labels make, one a point, by rising label; points of labels below 0 are in none.

        ``types`` (names) and ``surfaces`` are mappings by label, or sequences in the order of the labels that
        occur; ``None`` in them stands for one that is not known.
        """
        cloud = cloud_of(points)
        array = np.asarray(labels)
        if array.shape != (len(cloud),):
            raise ValueError(f"labels are one a point, shape ({len(cloud)},), not {array.shape}")
        whole = array.astype(np.int32)
        if not np.array_equal(whole, array):
            raise ValueError("labels are whole numbers of 32 bits; -1 stands for none")
        known = np.unique(whole[whole >= 0]).tolist()
        named = _by_label("types", types, known)
        shaped = {label: it.to_dict() for label, it in _by_label("surfaces", surfaces, known).items()}
        native = _engine.Segmentation.from_labels(np.ascontiguousarray(whole), named, shaped)
        return cls(native, cloud)

    @classmethod
    def from_primitives(cls, points: npt.ArrayLike, primitives: Sequence[Primitive]) -> Segmentation:
        """Primitives, of which number, points, type and surface are taken; both vectors follow from the surface."""
        cloud = cloud_of(points)
        given = [
            {
                "number": each.number,
                "points": np.ascontiguousarray(each.points, dtype=np.uint32),
                "type": each.type,
                "surface": None if each.surface is None else each.surface.to_dict(),
            }
            for each in primitives
        ]
        return cls(_engine.Segmentation.from_primitives(len(cloud), given), cloud)

    @property
    def primitives(self) -> tuple[Primitive, ...]:
        """The primitives, in order."""
        if self._primitives is None:
            found = self._native.primitives(self._cloud)
            self._primitives = tuple(
                Primitive(
                    **each,
                    surface=None if surface is None else surface_from(surface),
                    standard_errors=errors_from(errors),
                )
                for each, surface, errors in ((it, it.pop("surface"), it.pop("standardErrors")) for it in found)
            )
        return self._primitives

    @property
    def labels(self) -> npt.NDArray[np.int32]:
        """The place of its primitive for each point, -1 for none; of several, the last in order."""
        return self._native.labels(len(self._cloud))

    @property
    def noise(self) -> Optional[Noise]:
        """The noise that it was fitted by; ``None`` where it was not fitted here."""
        noise = self._native.noise()
        return None if noise is None else Noise(**noise)

    @property
    def types(self) -> dict[str, int]:
        """How many primitives there are of each type."""
        return self._native.types()

    def rows(self) -> list[Row]:
        """A row for each primitive: number, type, how many points, MFE and the numbers of its surface."""
        rows = []
        for each in self.primitives:
            surface = {} if each.surface is None else each.surface.to_dict()
            surface.pop("type", None)
            rows.append({"number": each.number, "type": each.type, "points": len(each), "mfe": each.mfe, **surface})
        return rows

    def __len__(self) -> int:
        return len(self._native)

    def __getitem__(self, index: Any) -> Any:
        return self.primitives[index]

    def __iter__(self) -> Iterator[Primitive]:
        return iter(self.primitives)

    def __repr__(self) -> str:
        counts = ", ".join(f"{count} {name}" for name, count in self.types.items() if count)
        return f"<Segmentation of {len(self._cloud)} points: {counts or 'nothing'}>"


def cloud_of(points: Any) -> _engine.Cloud:
    """The cloud of an array of shape (n, 3), of a model, or of a segmentation."""
    if isinstance(points, _engine.Cloud):
        return points
    own = getattr(points, "_cloud", None)
    if isinstance(own, _engine.Cloud):
        return own
    array = np.ascontiguousarray(points, dtype=np.float64)
    if array.ndim != 2 or array.shape[1] != 3:
        raise ValueError(f"points are an array of shape (n, 3), not {array.shape}")
    return _engine.Cloud(array)


def _by_label(what: str, given: ByLabel, labels: list[int]) -> dict[int, Any]:
    if given is None:
        return {}
    if isinstance(given, Mapping):
        strangers = set(given) - set(labels)
        if strangers:
            raise ValueError(f"{what}: no point has the label {min(strangers)}")
        pairs = given.items()
    else:
        if len(given) != len(labels):
            raise ValueError(f"{what}: {len(given)} are given for {len(labels)} labels that occur")
        pairs = zip(labels, given)  # type: ignore[assignment]
    return {int(label): it for label, it in pairs if it is not None}
