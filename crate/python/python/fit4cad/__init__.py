"""Read, fit and score planes, cylinders, cones, spheres and tori in point clouds of CAD objects.

The engine of the Fit4CAD playground, the same that runs in the browser and at its command line, with the same
digits. Points are arrays of shape (n, 3); results are typed and become tables by ``to_pandas`` and ``to_arrow``::

    import fit4cad
    model = fit4cad.generate("flange")
    found = fit4cad.fit(model.points, "ht")
    report = fit4cad.score(model.points, model.truth, found)
    report["DSC"], report.to_pandas()

``fit4cad.declared()`` lists measures, protocols, methods and their parameters; ``python -m fit4cad --help`` is the
command line; ``fit4cad.distributed`` does millions of models on Dask.
"""

from ._api import (
    check,
    degrade,
    distribution,
    fit,
    fit_many,
    fit_segments,
    fit_single,
    generate,
    score,
    score_field,
    score_many,
    statistics,
    summarise,
)
from ._declared import declared
from ._engine import __version__
from ._errors import Diagnostic, InputError
from ._files import export, read, read_all, write
from ._model import Model
from ._plot import plot, plot3d
from ._results import Audit, FieldReport, Finding, Hidden, PredictionRow, Report, Single, TruthRow, TypeConfusion
from ._segmentation import Noise, Primitive, Segmentation
from ._surfaces import Cone, Cylinder, Plane, Sphere, StandardErrors, Surface, Torus, surface_of

__all__ = [
    "Audit",
    "Cone",
    "Cylinder",
    "Diagnostic",
    "FieldReport",
    "Finding",
    "Hidden",
    "InputError",
    "Model",
    "Noise",
    "Plane",
    "PredictionRow",
    "Primitive",
    "Report",
    "Segmentation",
    "Single",
    "Sphere",
    "StandardErrors",
    "Surface",
    "Torus",
    "TruthRow",
    "TypeConfusion",
    "__version__",
    "check",
    "declared",
    "degrade",
    "distribution",
    "export",
    "fit",
    "fit_many",
    "fit_segments",
    "fit_single",
    "generate",
    "plot",
    "plot3d",
    "read",
    "read_all",
    "score",
    "score_field",
    "score_many",
    "statistics",
    "summarise",
    "surface_of",
    "write",
]
