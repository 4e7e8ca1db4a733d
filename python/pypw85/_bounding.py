# SPDX-License-Identifier: BSD-3-Clause
"""A bounding ellipsoid of each cluster of a system."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from ._enclosing import enclosing_ellipsoid_of
from ._errors import PW85Error
from ._numbers import instance
from ._system import System
from ._words import shown

# In the plane: entries of a form of an ellipse among those of an ellipsoid.
_OF_PLANE = [0, 1, 3]


def enclosing(system: System, clusters: ArrayLike | None = None, tolerance: float = 1e-6) -> System:
    """Computes the smallest ellipsoid around each cluster of a system. All particles of the cluster are inside (exact).

    Parameters
    ----------
    system : System
        A system of ellipsoids or ellipses. Images are ignored: if a periodic boundary divides a cluster, first join its parts.
    clusters : (n) array_like, optional
        The name of the cluster of each particle, any numbers or strings. By default all particles are one cluster.
    tolerance : float
        Largest relative excess of the volume (area) of an ellipsoid over the smallest possible one.

    Returns
    -------
    System
        One ellipsoid (ellipse) for each cluster, in the same cell, sorted by the names of the clusters. These are the types.

    Raises
    ------
    PW85Error
        The shape of a particle is not valid; see `enclosing_ellipsoid_of`.
    ValueError
        There is no particle, or `clusters` does not have one name for each particle.

    Examples
    --------
    >>> import pypw85
    >>> system = pypw85.System([[0, 0, 0], [3, 0, 0], [9, 9, 9]], [[1, 0, 0, 1, 0, 1]] * 3)
    >>> around = pypw85.enclosing(system, clusters=[1, 1, 2])
    >>> around.types, (around.centers.round(3) + 0).tolist()
    (array([1, 2]), [[1.5, 0.0, 0.0], [9.0, 9.0, 9.0]])
    """
    instance(system, System, "enclosing: system")
    if not len(system):
        raise ValueError("enclosing: system must have particles")
    labels = np.zeros(len(system.centers), np.int64) if clusters is None else np.asarray(clusters)
    if labels.dtype.kind not in "biufSU":
        raise TypeError(f"enclosing: clusters must be numbers or strings, not {shown(clusters)}")
    if labels.shape != (len(system.centers),):
        raise ValueError(f"enclosing: clusters must have one entry for each of {len(system)} particles, not the shape {labels.shape}")
    names, members = np.unique(labels, return_inverse=True)
    n, entries = (2, _OF_PLANE) if system.dimensions == 2 else (3, list(range(6)))
    centers, forms = np.zeros((len(names), 3)), np.tile([1.0, 0, 0, 1, 0, 1], (len(names), 1))
    for k in range(len(names)):
        chosen = members == k
        try:
            center, q, _ = enclosing_ellipsoid_of(system.centers[chosen, :n], system.q[np.ix_(chosen, entries)], tolerance)
        except PW85Error as error:
            detail = error.detail or error.reason
            where = "" if clusters is None else f"cluster {names[k]}: "
            raise PW85Error(error.status, "enclosing", error.reason, where + detail) from None
        centers[k, :n], forms[k, entries] = center, q
    return System(
        centers, forms, system.cell, system.periodic, types=names, origin=system.origin, step=system.step, dimensions=system.dimensions
    )
