"""What one does with points: score, fit, check, generate, degrade."""

from __future__ import annotations

from typing import Any, Iterable, Mapping, Optional, Sequence, Union

import numpy as np
import numpy.typing as npt

from . import _engine
from ._model import Model
from ._progress import Counted, Progress, of_fit, of_many
from ._results import Audit, FieldReport, Report, Single, Verdict
from ._segmentation import ByLabel, Segmentation, cloud_of
from ._surfaces import errors_from, surface_from

Points = Union[npt.ArrayLike, Model]
Labels = Union[npt.ArrayLike, Segmentation]


def _complete(
    cloud: _engine.Cloud, labels: Labels, types: ByLabel = None, surfaces: ByLabel = None
) -> tuple[_engine.Segmentation, bool]:
    """A segmentation with surfaces, and whether they were fitted here."""
    if isinstance(labels, Segmentation):
        if types is not None or surfaces is not None:
            raise ValueError("a segmentation has its own types and surfaces")
        return labels._native, False
    native = Segmentation.from_labels(cloud, labels, types, surfaces)._native  # type: ignore[arg-type]
    if not native.is_bare():
        return native, False
    return _engine.fit_segments(cloud, native)[0], True


def score(
    points: Points,
    truth: Labels,
    labels: Labels,
    types: ByLabel = None,
    surfaces: ByLabel = None,
    protocol: str = "definition",
    *,
    model: str = "",
    method: str = "",
) -> Report:
    """Scores a segmentation against the truth by every measure of the benchmark.

    ``points`` has shape (n, 3), any unit; ``truth`` and ``labels`` are labels of shape (n,), -1 for points of no
    primitive, or segmentations, in which primitives may share points. ``types`` and ``surfaces`` of the predicted
    segments stand by label, or in the order of the labels that occur. Labels that come without any surface get
    them by least squares, as files of labels do at the command line; the report says so.

    ``protocol`` is ``definition`` (the paper's formulas, exactly) or ``published`` (what the authors' scripts
    compute); the protocols of the rest of the field are in :func:`score_field`. Linear in the points listed.
    Raises ``ValueError`` for arrays of another shape, unknown names and labels that are no whole numbers.

    Source: Romanengo, Raffo, Qie, Anwer, Falcidieno: Fit4CAD. Computers & Graphics 2022, section "Quality indicators".
    """
    cloud = cloud_of(points)
    true, _ = _complete(cloud, truth)
    found, fitted = _complete(cloud, labels, types, surfaces)
    return Report._of(_engine.score(cloud, true, found, protocol, model, method), [], fitted)


def score_field(
    points: Points,
    truth: Labels,
    labels: Labels,
    types: ByLabel = None,
    surfaces: ByLabel = None,
    *,
    normalisation: Optional[str] = None,
    epsilon: Optional[float] = None,
    model: str = "",
    method: str = "",
) -> FieldReport:
    """Scores a segmentation by the protocols of the rest of the field (SPFN, ParseNet, HPNet, NVDNet, F1@0.5, PQ)
    and by its figures of fit. ``declared()["figures"]`` says of each what it computes, rewards and hides, and where
    it is from.

    Arguments are those of :func:`score`. Lengths are divided by the ``normalisation`` (``declared()
    ["normalisations"]``, by default SPFN's unit sphere); ``epsilon`` of the coverages is in its units. Raises
    ``ValueError`` as :func:`score` does, and for a negative ``epsilon``.
    """
    cloud = cloud_of(points)
    true, _ = _complete(cloud, truth)
    found, _ = _complete(cloud, labels, types, surfaces)
    return FieldReport._of(_engine.field(cloud, true, found, normalisation, epsilon, model, method))


def fit(
    points: Points, method: str = "ht", *, seed: int = 1, progress: Progress = None, **parameters: float
) -> Segmentation:
    """Fits primitives to a bare cloud: planes, cylinders, cones, spheres and tori, largest first.

    ``points`` has shape (n, 3); points that are not finite stay unsegmented. ``method`` is ``ht`` (Hough transform)
    or ``pg`` (primitive growing); the parameters of each, with unit, range and default, are in
    ``declared()["fitters"]``. The same points, parameters and seed give the same primitives, in whatever order the
    points are listed and on whatever machine. About O(n log n).

    ``progress(stage, fraction)`` hears how far it is; what it raises ends the fit. ``True`` shows a bar where tqdm
    is installed. The interpreter's lock is released, and Ctrl-C ends the fit. Raises ``ValueError`` for a parameter
    that is unknown or out of its range.

    Of a large cloud, ``subsample=50_000`` fits so many points and labels all by what was found.

    Source: Romanengo et al. 2022, sections "HT" and "PG".
    """
    return fit_titled(points, method, seed, progress, parameters)[0]


def fit_titled(
    points: Points, method: str, seed: int, progress: Progress, parameters: Mapping[str, float]
) -> tuple[Segmentation, str]:
    """What :func:`fit` finds, and what it is called: ``HT``, ``HT on 50000 points``."""
    cloud = cloud_of(points)
    values = {name: float(value) for name, value in parameters.items()}
    with of_fit(progress) as heard:
        found, title = _engine.fit(cloud, method, values, seed, heard)
    return Segmentation(found, cloud), title


def fit_segments(points: Points, labels: Labels, types: ByLabel = None) -> Segmentation:
    """Gives each segment the surface its points lie on, by least squares: of its own type where ``types`` name one,
    else of the type that its points speak for.

    ``points`` has shape (n, 3), ``labels`` shape (n,), -1 for none. Some 20 ms for a thousand points of a segment,
    linear beyond. Segments that have a surface keep it.
    """
    cloud = cloud_of(points)
    if isinstance(labels, Segmentation):
        native = labels._native
    else:
        native = Segmentation.from_labels(cloud, labels, types)._native  # type: ignore[arg-type]
    return Segmentation(_engine.fit_segments(cloud, native)[0], cloud)


def fit_single(points: Points, types: Sequence[str] = ()) -> Single:
    """Takes a cloud for one primitive, of one of the types or of any: the best surface, the best of another type and
    the margin between them. There is always an answer; noise and a share of outliers are borne."""
    found, _ = _engine.fit_single(cloud_of(points), None, list(types))
    best, second = map(_verdict, (found["best"], found["runnerUp"]))
    rest = {key: found[key] for key in ("number", "points", "margin", "answer")}
    return Single(best=best, runner_up=second, **rest)


def _verdict(found: dict[str, Any]) -> Verdict:
    surface, errors = surface_from(found.pop("surface")), errors_from(found.pop("standardErrors"))
    return Verdict(surface=surface, standard_errors=errors, **found)


def check(model: Points, truth: Optional[Labels] = None) -> Audit:
    """Audits a ground truth: points, parametric and implicit form of each primitive held against each other, and
    what was wrong with its files. ``Audit.corrected`` has surface files with wrong vectors replaced.

    Distances are shares of the diagonal of the primitive's box. Give a model as :func:`read` gives it, or points
    and a segmentation.
    """
    if isinstance(model, Model) and truth is None:
        return model.check()
    cloud = cloud_of(model)
    found = None if truth is None else Segmentation(_complete(cloud, truth)[0], cloud)
    return Model(cloud, found).check()


def generate(part: str, *, name: Optional[str] = None, **options: float) -> Model:
    """Makes a part of the catalogue with its ground truth: ``declared()["parts"]`` lists them.

    Options are those of ``declared()["sampleOptions"]``: ``spacing``, ``noise``, ``outliers`` and ``missing``, all
    shares, and ``seed``. One part, options and seed give one model everywhere. Raises ``ValueError`` for a part or
    an option that is unknown or out of its range.
    """
    cloud, truth = _engine.generate(part, {key: float(value) for key, value in options.items()})
    return Model(cloud, None if truth is None else Segmentation(truth, cloud), name=name or part)


def degrade(model: Points, truth: Optional[Labels] = None, **options: float) -> Model:
    """A cloud as a worse scan would show it: ``noise`` (standard deviation, of the diagonal), ``outliers`` (per
    point), ``missing`` (share cut away), ``density`` (how many times as dense at one end as at the other) and
    ``seed``: ``declared()["wear"]``. The truth keeps its surfaces and loses the points that are gone."""
    if not isinstance(model, Model):
        cloud = cloud_of(model)
        model = Model(cloud, None if truth is None else Segmentation(_complete(cloud, truth)[0], cloud))
    elif truth is not None:
        raise ValueError("a model has its own truth")
    return model.degraded(**{key: float(value) for key, value in options.items()})


def fit_many(
    clouds: Iterable[Points],
    method: str = "ht",
    *,
    seed: int = 1,
    jobs: int = 0,
    progress: Counted = None,
    **parameters: float,
) -> list[Segmentation]:
    """Fits many clouds side by side on ``jobs`` threads, 0 for all cores, as :func:`fit` does each: the same
    primitives whatever the number of jobs. ``progress(done, of)`` hears how many are done."""
    native = [cloud_of(points) for points in clouds]
    values = {name: float(value) for name, value in parameters.items()}
    with of_many(progress, f"fit {method}") as heard:
        found = _engine.fit_many(native, method, values, seed, jobs, heard)
    return [Segmentation(each, cloud) for each, cloud in zip(found, native)]


def score_many(
    models: Iterable[Model], protocol: str = "definition", *, jobs: int = 0, progress: Counted = None
) -> list[Report]:
    """Scores every submission of many models side by side on ``jobs`` threads, 0 for all cores: the same figures
    whatever the number of jobs, in the order of the models and their submissions."""
    cases = [(model, name) for model in models for name in model.submissions]
    native = [
        (model.name, name, model._cloud, model.segmentation()._native, model.submissions[name]._native)
        for model, name in cases
    ]
    with of_many(progress, "score") as heard:
        found = _engine.score_many(native, protocol, jobs, heard)
    return [Report._of(each, model._about(name), name in model.fitted) for each, (model, name) in zip(found, cases)]


def summarise(reports: Iterable[Report]) -> list[dict[str, Any]]:
    """Sums reports up method by method: of each measure count, mean, quartiles and extremes over the models."""
    return _engine.summarise([(each.method, each.mean, each.type_errors) for each in reports])


def distribution(values: npt.ArrayLike) -> Optional[dict[str, Any]]:
    """How figures are spread over models: count, mean, quartiles, extremes and the bootstrap 95 % interval of the
    mean. NaN stands for one that cannot be had; ``None`` where there is none."""
    return _engine.distribution(np.asarray(values, dtype=np.float64).ravel().tolist())


def statistics(models: Iterable[Model]) -> dict[str, Any]:
    """What a set of models holds: types of primitives, sizes, share of points that none lists."""
    counted = []
    for model in models:
        truth = None if model.truth is None else model.truth._native
        counted.append(_engine.statistics_of(model.name, model._cloud, truth))
    return _engine.statistics(counted)


