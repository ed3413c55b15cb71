"""``fit4cad score`` by the protocols and figures that the rest of the field reports."""

from __future__ import annotations

import json
import os
from dataclasses import dataclass
from typing import Any, Callable, Mapping, Optional, Sequence

from .. import _engine
from .._declared import declared, names
from .._errors import Diagnostic
from .._files import File
from .._model import Model
from .arguments import Option, UsageError, choice, named, number
from .field_json import field_json
from .field_sheets import field_sheets
from .sheet import SHEET_WRITERS
from .terminal import clear, print_text, tell, warn

Row = dict[str, Any]

OPTIONS = (
    Option("measures", "figures of fit, or all; true and predicted primitives are matched one to one", "NAME,NAME…"),
    Option("normalisation", "what lengths are divided by", "NAME"),
    Option("epsilon", "ε of the coverages in that unit"),
    Option("by", "also how primitives fare by what they are, and figures by the conditions of models", "NAME,NAME…"),
)

#: What a manifest calls the conditions that it declares.
_DEGRADATION = ("noise", "missing")


@dataclass(frozen=True)
class Field:
    """What is asked for beyond the benchmark's measures."""

    figures: Sequence[Row]
    normalisation: str
    epsilon: float
    by: Sequence[Row]
    """The strata."""
    segments: bool
    """Whether SHREC 2022's tables of segments."""


def _of_group(group: str) -> list[str]:
    return [each["key"] for each in declared()["figures"] if each["group"] == group]


def field_of(values: Mapping[str, Any]) -> Optional[Field]:
    """What is asked for beyond the benchmark's measures; ``None`` where nothing is."""
    protocol, measures, by = values["protocol"], values["measures"], values["by"]
    if protocol in names("protocols") and measures is None and by is None:
        if values["normalisation"] is not None or values["epsilon"] is not None:
            raise UsageError("--normalisation and --epsilon are for --measures: name some, or all")
        return None
    usual = declared()["figureScale"]
    said = usual["normalisation"] if values["normalisation"] is None else values["normalisation"]
    normalisation = choice("normalisation", said, names("normalisations"))
    epsilon = number("epsilon", values["epsilon"], least=0)
    protocols = _protocols(protocol, measures)
    wanted = [*protocols, *_figures(measures)]
    strata = [] if by is None else named("by", by, names("strata"))
    return Field(
        # In the order of the list, each once.
        [each for each in declared()["figures"] if each["key"] in wanted],
        normalisation,
        usual["epsilon"] if epsilon is None else epsilon,
        [each for each in declared()["strata"] if each["name"] in strata],
        declared()["recognition"]["key"] in protocols,
    )


def _protocols(protocol: str, measures: Optional[str]) -> list[str]:
    paper, segmentation = names("protocols"), _of_group("segmentation")
    if protocol == paper[0] and measures is not None:
        return []
    known = [*paper, *segmentation, declared()["recognition"]["key"]]
    every = segmentation if protocol == "all" else named("protocol", protocol, known)
    # Both of the benchmark's protocols have one DSC.
    return ["fit4cad" if each in paper else each for each in every]


def _figures(measures: Optional[str]) -> list[str]:
    if measures is None:
        return []
    return _of_group("fit") if measures == "all" else named("measures", measures, names("figures"))


def score_field(
    evaluate: Callable[[Callable[[Model, Optional[str]], Row]], list[Row]],
    files: Sequence[File],
    problems: list[Diagnostic],
    field: Field,
    form: str,
) -> int:
    """Scores and prints; gives the exit code."""
    conditioned = any(each["isCondition"] for each in field.by)
    results = evaluate(lambda model, method: _report(model, method, field, conditioned))
    if conditioned:
        known = _declared_conditions(files)
        for result in results:
            own = {each["by"]: each for each in known.get(result["model"], [])}
            result["conditions"] = [own.get(each["by"], each) for each in result["conditions"]]
    clear()
    failed = tell(problems)
    if not results:
        from .score import NOTHING

        warn(NOTHING)
    print_text(field_json(results, field) if form == "json" else SHEET_WRITERS[form](field_sheets(results, field)))
    return 1 if failed or not results else 0


def _report(model: Model, method: Optional[str], field: Field, conditioned: bool) -> Row:
    report = model.score_field(method, normalisation=field.normalisation, epsilon=field.epsilon).to_dict()
    truth, found = model.segmentation()._native, model.segmentation(method)._native
    if conditioned:
        report = {**report, "conditions": _engine.conditions(model._cloud, truth)}
    if field.segments:
        report = {**report, "segments": _engine.segments(model._cloud, truth, found, field.normalisation)}
    return report


def _declared_conditions(files: Sequence[File]) -> dict[str, list[Row]]:
    """By model, the conditions that the manifest of a set among the files declares. What is no such manifest declares
    nothing, and what two declare differently is left to be measured."""
    by_model: dict[str, list[Row]] = {}
    for file in files:
        if os.path.basename(file.path) != "manifest.json":
            continue
        manifest = _parsed(file)
        degradation, models = manifest.get("degradation"), manifest.get("models")
        given = degradation if isinstance(degradation, dict) else {}
        values = [(by, given.get(by)) for by in _DEGRADATION]
        known = [_engine.declared_condition(by, it) for by, it in values if isinstance(it, float) and it >= 0]
        conditions = [condition for condition in known if condition is not None]
        for model in models if isinstance(models, list) else []:
            name = model.get("model") if isinstance(model, dict) else None
            if isinstance(name, str):
                before = by_model.get(name)
                by_model[name] = conditions if before is None else [one for one in before if one in conditions]
    return by_model


def _refused(word: str) -> float:
    raise ValueError(word)


def _parsed(file: File) -> Row:
    try:
        # Whole numbers of any length are numbers, and what is no JSON is none.
        found = json.loads(file.read().decode("utf-8", "replace"), parse_int=float, parse_constant=_refused)
    except (OSError, ValueError, RecursionError):
        return {}
    return found if isinstance(found, dict) else {}
