# SPDX-License-Identifier: BSD-3-Clause
"""A picture of two ellipsoids and their contact. Needs Matplotlib, which is imported only here."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import plain
from ._errors import named
from ._forms import principal_axes
from ._functions import contact, contact_geometry
from ._typing import Floats

_COLOURS = ("tab:blue", "tab:orange")


def plot(
    center1: ArrayLike, q1: ArrayLike, center2: ArrayLike, q2: ArrayLike, ax: Any | None = None, resolution: int = 32
) -> Any:
    """Draw two ellipsoids, the pair scaled by μ, their contact point and common normal.

    Parameters
    ----------
    center1, center2 : (3) array_like
        Centres, which may not coincide.
    q1, q2 : (6) array_like
        Forms.
    ax : matplotlib axes with ``projection="3d"``, optional
        Axes to draw in. By default those of a new figure.
    resolution : int
        Number of steps from pole to pole.

    Returns
    -------
    axes
        With these artists, found by ``get_label()``: "ellipsoid 1", "ellipsoid 2" (surfaces), "scaled 1", "scaled 2"
        (wire frames), "contact point", "normal".

    Raises
    ------
    ImportError
        Matplotlib is not installed.
    PW85Error
        Invalid input, or coincident centres.
    """
    c1, q1, c2, q2 = (np.asarray(plain(x), dtype=np.float64) for x in (center1, q1, center2, q2))
    with named("plot"):
        mu2, lambda_ = contact(c2 - c1, q1, q2)
        point, normal = contact_geometry(c2 - c1, q1, q2, lambda_)
    ax = _new_axes() if ax is None else ax
    ax.computed_zorder = False  # so that what is drawn in front stays there
    for k, (center, q) in enumerate(((c1, q1), (c2, q2))):
        solid = surface(center, q, 1.0, resolution)
        scaled = surface(center, q, float(np.sqrt(mu2)), resolution)
        ax.plot_surface(*solid, color=_COLOURS[k], alpha=0.5, label=f"ellipsoid {k + 1}", zorder=1)
        ax.plot_wireframe(*scaled, color=_COLOURS[k], alpha=0.3, linewidth=0.5, label=f"scaled {k + 1}", zorder=2)
    x0 = c1 + point
    ax.scatter(*x0[:, np.newaxis], color="black", label="contact point", zorder=4)
    ax.quiver(*x0, *normal, length=0.5 * np.linalg.norm(c2 - c1), color="black", label="normal", zorder=3)
    ax.set(xlabel="x", ylabel="y", zlabel="z", title=f"μ² = {mu2:.6g}, λ = {lambda_:.6g}")
    ax.set_aspect("equal")
    ax.legend(handles=_legend(), loc="upper left", bbox_to_anchor=(0, 1), fontsize="small")
    return ax


def _new_axes() -> Any:
    """Three-dimensional axes that fill a new figure."""
    import matplotlib.pyplot

    return matplotlib.pyplot.figure(figsize=(7, 6)).add_axes((0.0, 0.03, 0.92, 0.92), projection="3d")


def _legend() -> list[Any]:
    """Samples for a legend: Matplotlib has none for surfaces before 3.7."""
    from matplotlib.lines import Line2D
    from matplotlib.patches import Patch

    solids: list[Any] = [Patch(color=colour, alpha=0.5, label=f"ellipsoid {k + 1}") for k, colour in enumerate(_COLOURS)]
    wires = Line2D([], [], color="gray", linewidth=0.5, label="scaled by μ")
    point = Line2D([], [], color="black", marker="o", label="contact point, normal")
    return [*solids, wires, point]


def surface(center: ArrayLike, q: ArrayLike, scale: float, resolution: int) -> Floats:
    """Points (3, resolution + 1, 2 resolution + 1) on an ellipsoid scaled by `scale`."""
    semi_axes, rotation = principal_axes(q)
    theta = np.linspace(0, np.pi, resolution + 1)[:, np.newaxis]
    phi = np.linspace(0, 2 * np.pi, 2 * resolution + 1)
    sphere = np.stack(
        [np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi), np.cos(theta) * np.ones_like(phi)]
    )
    shift = np.asarray(center, dtype=np.float64)[:, np.newaxis, np.newaxis]
    points: Floats = np.tensordot(rotation * (scale * semi_axes), sphere, axes=1) + shift
    return points
