"""A model: a cloud, its truth and what methods found in it."""

from __future__ import annotations

from typing import Any, Optional, Union

import numpy as np
import numpy.typing as npt

from . import _engine
from ._errors import Diagnostic
from ._progress import Progress
from ._results import Audit, FieldReport, Finding, Report
from ._segmentation import Segmentation, cloud_of


class Model:
    """A point cloud with its ground truth, if there is one, and the results of methods by their names.

    ``diagnostics`` tell what was wrong with its files; ``fitted`` names the methods whose segments came without
    surfaces and got them here (``None`` for the truth); ``imported`` says what became of the faces of a STEP file.
    """

    def __init__(
        self,
        points: Union[npt.ArrayLike, _engine.Cloud],
        truth: Optional[Segmentation] = None,
        submissions: Optional[dict[str, Segmentation]] = None,
        name: str = "model",
    ) -> None:
        self.name = name
        self._cloud = cloud_of(points)
        self.truth = truth
        self.submissions = dict(submissions or {})
        self.fitted: set[Optional[str]] = set()
        self.imported: Optional[dict[str, Any]] = None
        self._findings: Any = None
        self._points: Optional[npt.NDArray[np.float64]] = None

    @property
    def points(self) -> npt.NDArray[np.float64]:
        """The points, shape (n, 3), read-only: made once, and handed on without a copy."""
        if self._points is None:
            self._points = self._cloud.points()
            self._points.flags.writeable = False
        return self._points

    @property
    def numbers(self) -> npt.NDArray[np.uint64]:
        """The number of each point in its file, from 1: its index and one, but for files with broken rows."""
        numbers = self._cloud.numbers()
        return np.arange(1, len(self) + 1, dtype=np.uint64) if numbers is None else numbers

    @property
    def diagnostics(self) -> list[Diagnostic]:
        """What is wrong with the files it was read from."""
        return [] if self._findings is None else [Diagnostic(**each) for each in self._findings.all()]

    def _about(self, method: Optional[str]) -> list[Diagnostic]:
        return [] if self._findings is None else [Diagnostic(**each) for each in self._findings.about(method)]

    def segmentation(self, method: Optional[str] = None) -> Segmentation:
        """What a method found, or the truth. Raises ``ValueError`` where there is none."""
        if method is None:
            if self.truth is None:
                raise ValueError(f"{self.name} has no ground truth")
            return self.truth
        if method not in self.submissions:
            there = ", ".join(self.submissions) or "none at all"
            raise ValueError(f"{self.name} has no submission of `{method}`; there is {there}")
        return self.submissions[method]

    def fit(self, method: str = "ht", *, seed: int = 1, progress: Progress = None, **parameters: float) -> str:
        """Fits primitives to the bare cloud and keeps them as a submission; gives its name.

        That is the method's abbreviation, with the number of points where only some were fitted (``subsample``) and
        one behind it where it is taken. See :func:`fit4cad.fit`.
        """
        from ._api import fit_titled

        found, title = fit_titled(self, method, seed, progress, parameters)
        name, number = title, 2
        while name in self.submissions:
            name, number = f"{title} {number}", number + 1
        self.submissions[name] = found
        return name

    def score(self, method: Optional[str] = None, protocol: str = "definition") -> Report:
        """Every measure of the benchmark of a method's result, or of the truth against itself."""
        truth, found = self.segmentation(), self.segmentation(method)
        name = "truth" if method is None else method
        report = _engine.score(self._cloud, truth._native, found._native, protocol, self.name, name)
        return Report._of(report, self._about(method), method is not None and method in self.fitted)

    def score_field(
        self, method: Optional[str] = None, *, normalisation: Optional[str] = None, epsilon: Optional[float] = None
    ) -> FieldReport:
        """What the rest of the field reports of a method's result: see :func:`fit4cad.score_field`."""
        truth, found = self.segmentation()._native, self.segmentation(method)._native
        name = "truth" if method is None else method
        return FieldReport._of(_engine.field(self._cloud, truth, found, normalisation, epsilon, self.name, name))

    def check(self) -> Audit:
        """What is wrong with its files and its ground truth: see :func:`fit4cad.check`."""
        truth = None if self.truth is None else self.truth._native
        found = _engine.audit(self.name, self._cloud, truth, self._findings)
        found["findings"] = [Finding(**each) for each in found["findings"]]
        if truth is None:
            return Audit(**found)
        rows, texts = _engine.corrected(self._cloud, truth)
        corrections = [dict(zip(("primitive", "form", "from"), row)) for row in rows]
        return Audit(**found, corrections=corrections, corrected=texts)

    def degraded(self, **options: float) -> Model:
        """As a worse scan would show it, with its truth and without its submissions: see :func:`fit4cad.degrade`."""
        truth = None if self.truth is None else self.truth._native
        cloud, left = _engine.degrade(self._cloud, truth, options)
        model = Model(cloud, None if left is None else Segmentation(left, cloud), name=self.name)
        model._findings = self._findings
        return model

    def imperfect(self, seed: int = 1) -> str:
        """Adds a submission that is wrong on purpose, in ways that are common, and gives its name."""
        found = _engine.imperfect(self.name, self._cloud, self.segmentation()._native, seed)
        self.submissions["Imperfect"] = Segmentation(found, self._cloud)
        return "Imperfect"

    def __len__(self) -> int:
        return len(self._cloud)

    def __repr__(self) -> str:
        truth = "no truth" if self.truth is None else f"{len(self.truth)} true primitives"
        methods = ", ".join(self.submissions) or "no submission"
        return f"<Model {self.name}: {len(self)} points, {truth}, {methods}>"
