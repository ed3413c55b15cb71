"""Pictures of clouds and segmentations, through viewers that are installed already."""

from __future__ import annotations

from typing import Any, Optional, Union

import numpy as np
import numpy.typing as npt

from ._model import Model
from ._palette import SEGMENTS
from ._segmentation import Segmentation, cloud_of
from ._tables import wanted


def colours(segmentation: Optional[Segmentation], points: int) -> npt.NDArray[np.uint8]:
    """Red, green and blue of each point, shape (n, 3): those of the page."""
    palette = np.asarray(SEGMENTS, dtype=np.uint8)
    if segmentation is None:
        return np.broadcast_to(palette[0], (points, 3)).copy()
    labels = segmentation.labels
    return palette[np.where(labels < 0, 0, 1 + labels % (len(palette) - 1))]


def _of(model: Any, found: Union[Segmentation, str, None]) -> tuple[npt.NDArray[np.float64], Optional[Segmentation]]:
    segmentation: Optional[Segmentation] = model.segmentation(found) if isinstance(found, str) else found
    if segmentation is None and isinstance(model, Model):
        segmentation = model.truth
    return cloud_of(model).points(), segmentation


def plot(model: Any, found: Union[Segmentation, str, None] = None, *, ax: Any = None, size: float = 2.0) -> Any:
    """Draws a cloud by segment with matplotlib; gives the axes.

    ``model`` is a model or points of shape (n, 3), ``found`` a segmentation or the name of a submission; of a model
    without it the truth is drawn. ``size`` is the area of a point's mark, in square points of print.
    """
    points, segmentation = _of(model, found)
    if ax is None:
        ax = wanted("matplotlib.pyplot").figure().add_subplot(projection="3d")
    ax.scatter(*points.T, c=colours(segmentation, len(points)) / 255, s=size, linewidths=0, depthshade=False)
    ax.set_aspect("equal")
    ax.set_axis_off()
    return ax


def plot3d(model: Any, found: Union[Segmentation, str, None] = None, *, viewer: Optional[str] = None) -> Any:
    """Shows a cloud by segment in a viewer that can be turned: k3d (notebooks) or pyvista, whichever is installed,
    or the one named; gives its plot, or plotter, to be shown. Arguments are those of :func:`plot`."""
    points, segmentation = _of(model, found)
    shades = colours(segmentation, len(points))
    spacing = float(np.linalg.norm(np.ptp(points, axis=0))) / 400 if len(points) else 1.0
    for name in ("k3d", "pyvista") if viewer is None else (viewer,):
        try:
            module = wanted(name)
        except ModuleNotFoundError:
            if viewer is not None:
                raise
            continue
        if name == "k3d":
            packed = (shades.astype(np.uint32) << np.array([16, 8, 0], dtype=np.uint32)).sum(axis=1)
            shown = module.plot()
            shown += module.points(points.astype(np.float32), colors=packed.astype(np.uint32), point_size=spacing)
            return shown
        if name == "pyvista":
            plotter = module.Plotter()
            plotter.add_points(points, scalars=shades, rgb=True, point_size=4)
            return plotter
        raise ValueError(f"there is no viewer `{name}`; there are k3d, pyvista")
    raise ModuleNotFoundError("no viewer is installed: pip install k3d, or pyvista")
