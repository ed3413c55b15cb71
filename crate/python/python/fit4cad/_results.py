"""Scores and audits as typed results, with the names of the command line's JSON."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Optional

from ._errors import Diagnostic
from ._tables import Row, Table

Value = Optional[float]


@dataclass(frozen=True)
class TruthRow:
    """How one true primitive was recognised: its match among the predictions, and every measure by its key."""

    truth: int
    match: Optional[int]
    type: Optional[str]
    size: int
    measures: dict[str, Value]


@dataclass(frozen=True)
class PredictionRow:
    """How well one predicted primitive fits; ``match`` is the true primitive it shares most points with."""

    prediction: int
    match: Optional[int]
    type: Optional[str]
    size: int
    measures: dict[str, Value]
    type_error: bool


@dataclass(frozen=True)
class TypeConfusion:
    """Types of true primitives (rows) against types of their matches (columns)."""

    truth: list[str]
    match: list[str]
    counts: list[list[int]]


@dataclass(frozen=True)
class Hidden:
    """What the paper's measures hide: true primitives missed or merged, predictions that match none, by number."""

    missed: list[int]
    merged: list[int]
    spurious: list[int]
    prediction_dsc: Value
    types: TypeConfusion
    labelled: Value
    truth_labelled: Value


def _split(row: Row, keys: tuple[str, ...]) -> tuple[Row, dict[str, Value]]:
    return {key: row[key] for key in keys}, {key: it for key, it in row.items() if key not in keys}


@dataclass(frozen=True)
class Report(Table):
    """The score of one submission: every measure of the benchmark under one protocol.

    ``mean`` has the measures of the whole submission by their keys (``fit4cad.declared()["measures"]`` says what
    each is), ``None`` where one cannot be had. Rows are those of the true primitives.
    """

    model: str
    method: str
    protocol: str
    points: int
    truth: int
    predicted: int
    mean: dict[str, Value]
    type_errors: int
    primitives: list[TruthRow]
    predictions: list[PredictionRow]
    hidden: Hidden
    diagnostics: list[Diagnostic] = field(default_factory=list)
    surfaces_fitted: bool = False
    """Whether the surfaces of the submission were fitted here, to labels that came without."""
    _dict: Row = field(default_factory=dict, repr=False, compare=False)

    @classmethod
    def _of(cls, found: Row, diagnostics: list[Diagnostic], surfaces_fitted: bool) -> Report:
        truths = [_split(row, ("truth", "match", "type", "size")) for row in found["primitives"]]
        keys = ("prediction", "match", "type", "size", "type_error")
        predictions = [_split(row, keys) for row in found["predictions"]]
        hidden = found["hidden"]
        rest = {
            "primitives": [TruthRow(**own, measures=measures) for own, measures in truths],
            "predictions": [PredictionRow(**own, measures=measures) for own, measures in predictions],
            "hidden": Hidden(**{**hidden, "types": TypeConfusion(**hidden["types"])}),
        }
        plain = {**found, "diagnostics": [each.to_dict() for each in diagnostics]}
        if surfaces_fitted:
            plain["surfacesFitted"] = True
        return cls(**{**found, **rest}, diagnostics=diagnostics, surfaces_fitted=surfaces_fitted, _dict=plain)

    def __getitem__(self, measure: str) -> Value:
        """A mean by the key of its measure."""
        return self.mean[measure]

    def to_dict(self) -> Row:
        """Plain values with the keys of the command line's JSON."""
        return self._dict

    def rows(self) -> list[Row]:
        """A row for each true primitive."""
        rows: list[Row] = self._dict["primitives"]
        return rows

    def summary(self) -> Row:
        """One row for the whole submission, to be stacked over models."""
        head = {key: self._dict[key] for key in ("model", "method", "protocol", "points", "truth", "predicted")}
        return {**head, **self.mean, "type_errors": self.type_errors}


@dataclass(frozen=True)
class FieldRow:
    """How one true primitive fares by the field's one-to-one matching."""

    truth: int
    type: Optional[str]
    size: int
    stratum: str
    iou: float


@dataclass(frozen=True)
class FieldReport(Table):
    """What the rest of the field reports of one submission: scores by each protocol and figures of fit, by key."""

    model: str
    method: str
    scale: dict[str, Any]
    figures: dict[str, Value]
    types: TypeConfusion
    primitives: list[FieldRow]
    _dict: Row = field(default_factory=dict, repr=False, compare=False)

    @classmethod
    def _of(cls, found: Row) -> FieldReport:
        rows = [FieldRow(**row) for row in found["primitives"]]
        return cls(**{**found, "types": TypeConfusion(**found["types"]), "primitives": rows}, _dict=found)

    def __getitem__(self, figure: str) -> Value:
        """A figure by its key."""
        return self.figures[figure]

    def to_dict(self) -> Row:
        """Plain values with the keys of the command line's JSON."""
        return self._dict

    def rows(self) -> list[Row]:
        """A row for each true primitive."""
        rows: list[Row] = self._dict["primitives"]
        return rows


@dataclass(frozen=True)
class Finding:
    """One thing that is wrong with a ground truth; ``value`` and ``limit`` are shares of the primitive's diagonal."""

    primitive: Optional[int]
    check: str
    severity: str
    value: Value
    limit: Value
    message: str
    hint: str


@dataclass(frozen=True)
class Audit(Table):
    """What an audit found: findings first about whole files, then by primitive, and the measurements behind them."""

    model: str
    findings: list[Finding]
    primitives: list[Row]
    corrections: list[Row] = field(default_factory=list)
    corrected: dict[str, str] = field(default_factory=dict, repr=False)
    """Texts of surface files with wrong vectors replaced by exact conversions of right ones, by form."""

    @property
    def ok(self) -> bool:
        """Whether nothing is wrong: notes at most."""
        return all(finding.severity == "note" for finding in self.findings)

    def to_dict(self) -> Row:
        """Plain values with the keys of the command line's JSON."""
        from dataclasses import asdict

        findings = [asdict(finding) for finding in self.findings]
        return {"model": self.model, "findings": findings, "primitives": self.primitives}

    def rows(self) -> list[Row]:
        """A row for each finding."""
        rows: list[Row] = self.to_dict()["findings"]
        return rows


@dataclass(frozen=True)
class Verdict:
    """A surface and how far its points are from it, in the units of the cloud."""

    type: str
    surface: Any
    standard_errors: Any
    mean: float
    rms: float
    largest: float


@dataclass(frozen=True)
class Single:
    """What a group of points is as one primitive, the best of another type, and how sure that is.

    ``margin`` says how many times as far the points typically are from the runner-up, parameters paid for;
    ``answer`` is the answer column of SHREC 2022.
    """

    number: int
    points: int
    best: Verdict
    runner_up: Verdict
    margin: float
    answer: str
