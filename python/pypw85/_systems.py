# SPDX-License-Identifier: BSD-3-Clause
"""Systems of particles: derivatives, forces, one ellipsoid against many, nearest images."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._device import apply_to_pairs, is_device_array
from ._errors import PW85Error
from ._explanations import explain_values
from ._functions import ContactDerivatives
from ._pairs import _cell, _explain, _images, _int32, _pair_list, _particles, _rows
from ._typing import Floats


class ContactForces(NamedTuple):
    """Forces and torques on the particles, and the virial, of an energy of pairs."""

    forces: Floats
    torques: Floats
    virial: Floats


def contact_derivatives_pairs(
    pairs: ArrayLike,
    centers: ArrayLike,
    q: ArrayLike,
    cell: ArrayLike | None = None,
    images: ArrayLike | None = None,
) -> ContactDerivatives:
    """`contact_derivatives` for the pairs of a neighbour list.

    Parameters
    ----------
    pairs, centers, q, cell, images
        As for `contact_pairs`.

    Returns
    -------
    ContactDerivatives
        Arrays with one row for each pair; NaN for a bad pair, which NumPy reports as ``np.errstate(invalid=...)`` says.

    Raises
    ------
    IndexError
        An index is not in [0, n).
    ValueError
        Shapes do not match, or the cell is singular or not finite.

    Examples
    --------
    >>> import numpy as np, pypw85
    >>> q = np.array([pypw85.spheroid(1, 1, [0, 0, 1])] * 2)
    >>> centers, cell = [[0, 0, 0], [9, 0, 0]], 10 * np.eye(3)
    >>> pypw85.contact_derivatives_pairs([[0, 1]], centers, q, cell=cell).d_r12
    array([[-0.5,  0. ,  0. ]])
    """
    if is_device_array(pairs):
        return ContactDerivatives(*apply_to_pairs("contact_derivatives", pairs, centers, q, _cell(cell), images))
    arrays = _pair_list(pairs, centers, q, cell, images)
    n = len(arrays[0])
    result = ContactDerivatives(np.full(n, -1.0), np.empty(n), *(np.empty((n, 3)) for _ in range(5)))
    status = _core.contact_derivatives_pairs(*arrays, *result)
    if status:
        _explain(status, *arrays, refused=n == 0 or result.mu2[0] == -1.0)
        _core.report_contact_pairs(status)
    return result


def contact_forces_pairs(
    pairs: ArrayLike,
    centers: ArrayLike,
    d_u: ArrayLike,
    derivatives: ContactDerivatives,
    cell: ArrayLike | None = None,
    images: ArrayLike | None = None,
) -> ContactForces:
    """Forces, torques and virial of an energy U(μ²) of the pairs of a neighbour list.

    Parameters
    ----------
    pairs, centers, cell, images
        As for `contact_pairs`.
    d_u : (n) array_like
        dU/dμ² of each pair. Where it is 0 the pair is left out, whatever its derivatives.
    derivatives : ContactDerivatives
        From `contact_derivatives_pairs`.

    Returns
    -------
    ContactForces
        A named tuple: `forces` and `torques` (N, 3) on the particles, and the `virial` (3, 3), Σ r12 ⊗ force on the second particle of
        each pair. The bits do not depend on the number of threads.

    Raises
    ------
    IndexError
        An index is not in [0, N).
    ValueError
        Shapes do not match, or the cell is singular or not finite.

    Examples
    --------
    >>> import numpy as np, pypw85
    >>> q = np.array([pypw85.spheroid(1, 1, [0, 0, 1])] * 2)
    >>> pairs, centers = [[0, 1]], [[0, 0, 0], [1, 0, 0]]
    >>> derivatives = pypw85.contact_derivatives_pairs(pairs, centers, q)
    >>> slopes = 2 * (derivatives.mu2 - 1)
    >>> pypw85.contact_forces_pairs(pairs, centers, slopes, derivatives).forces
    array([[-0.75,  0.  ,  0.  ],
           [ 0.75,  0.  ,  0.  ]])
    """
    arrays = _pair_list(pairs, centers, None, cell, images)
    n, num_particles = len(arrays[0]), len(arrays[1])
    slopes = np.require(d_u, np.float64, ["C", "A"])
    if slopes.shape != (n,):
        raise ValueError(f"d_u must have the shape ({n},), but it is {slopes.shape}")
    rows = [_rows(getattr(derivatives, name), 3, name) for name in ("d_r12", "d_rot1", "d_rot2")]
    if any(len(array) != n for array in rows):
        raise ValueError(f"there are {n} pairs, but derivatives of another number")
    result = ContactForces(np.empty((num_particles, 3)), np.empty((num_particles, 3)), np.empty((3, 3)))
    status = _core.contact_forces_pairs(*arrays, slopes, *rows, *result)
    if status:
        _explain(status, *arrays, refused=True)
    return result


class Law(NamedTuple):
    """The energy U(μ²) of a pair, for `law_forces_pairs`."""

    kind: int
    parameters: Floats

    @classmethod
    def soft_repulsion(cls, energy: float, exponent: float = 2.0) -> Law:
        """U = energy/exponent (1 - μ)**exponent for μ < 1 and 0 beyond; the exponent is at least 1."""
        return cls(1, np.array([energy, exponent], dtype=np.float64))

    @classmethod
    def inverse_powers(
        cls, repulsion: float, n: float, attraction: float, m: float, mu2_max: float = float(np.finfo(float).max)
    ) -> Law:
        """U = repulsion μ**-n - attraction μ**-m, less the value of that at the cutoff `mu2_max`; 0 beyond. n > m > 0."""
        return cls(2, np.array([repulsion, n, attraction, m, mu2_max], dtype=np.float64))

    @classmethod
    def table(cls, mu2_min: float, mu2_max: float, u: ArrayLike, d_u: ArrayLike) -> Law:
        """Energies and their derivatives at equally spaced μ², between which U is cubic; linear below, 0 from `mu2_max` on."""
        points = np.stack([np.asarray(u, dtype=np.float64), np.asarray(d_u, dtype=np.float64)], axis=1)
        return cls(3, np.concatenate([[mu2_min, mu2_max], points.ravel()]))


class LawForces(NamedTuple):
    """What a law does to the particles."""

    energy: float
    forces: Floats
    torques: Floats
    virial: Floats


def law_forces_pairs(
    pairs: ArrayLike,
    centers: ArrayLike,
    q: ArrayLike,
    law: Law,
    cell: ArrayLike | None = None,
    images: ArrayLike | None = None,
) -> LawForces:
    """Energy, forces, torques and virial of the pairs of a neighbour list, whose energy is a law of μ².

    It takes little more time than `contact_derivatives_pairs` alone.

    Parameters
    ----------
    pairs, centers, q, cell, images
        As for `contact_pairs`.
    law : Law
        The energy of a pair.

    Returns
    -------
    LawForces
        A named tuple: the `energy`, the `forces` and `torques` (N, 3) on the particles, and the `virial` (3, 3), as of
        `contact_forces_pairs`. Sums to which a bad pair contributes are NaN, which NumPy reports as ``np.errstate(invalid=...)``
        says. The bits do not depend on the number of threads.

    Raises
    ------
    IndexError
        An index is not in [0, N).
    ValueError
        Shapes do not match, the law does not allow its parameters, or the cell is singular or not finite.

    Examples
    --------
    >>> import numpy as np, pypw85
    >>> q = np.array([pypw85.spheroid(1, 1, [0, 0, 1])] * 2)
    >>> law = pypw85.Law.soft_repulsion(8)
    >>> sums = pypw85.law_forces_pairs([[0, 1]], [[0, 0, 0], [1, 0, 0]], q, law)
    >>> sums.energy, sums.forces
    (1.0, array([[-2.,  0.,  0.],
           [ 2.,  0.,  0.]]))
    """
    arrays = _pair_list(pairs, centers, q, cell, images)
    num_particles = len(arrays[1])
    parameters = np.require(law.parameters, np.float64, ["C", "A"])
    energy = np.full(1, -np.inf)
    result = LawForces(0.0, np.empty((num_particles, 3)), np.empty((num_particles, 3)), np.empty((3, 3)))
    status = _core.law_forces_pairs(*arrays, law.kind, parameters, energy, *result[1:])
    if status and energy[0] == -np.inf:
        no_pairs = np.empty((0, 2), dtype=np.int32)
        if _core.law_forces_pairs(no_pairs, *arrays[1:3], None, None, law.kind, parameters, energy, *result[1:]):
            raise ValueError(f"the law does not allow these parameters: {law.parameters}")
        _explain(status, *arrays, refused=True)
    if status:
        _core.report_contact_pairs(status)
    return result._replace(energy=float(energy[0]))


def overlap_any_indices(
    center: ArrayLike,
    q1: ArrayLike,
    indices: ArrayLike,
    centers: ArrayLike,
    q: ArrayLike,
    cell: ArrayLike | None = None,
    images: ArrayLike | None = None,
) -> bool:
    """Whether an ellipsoid overlaps any of the given particles of a system, as the test of a Monte Carlo move.

    Without `images` the answer is about all images of the others, and of the one itself: an error where none of the nearest ones
    overlaps, but others could (`nearest_image_limit` of the one and the others is below 1). There, take the images of a neighbour
    list, and write the trial into `centers` and `q` before the call, since its own index stands for images of itself.

    Parameters
    ----------
    center : (3) array_like
        Centre of the one.
    q1 : (6) array_like
        Its form.
    indices : (n) array_like of int
        The others.
    centers, q : (N, 3) and (N, 6) array_like
        All particles.
    cell : (3, 3) array_like, optional
        Rows are the vectors of the periodic cell.
    images : (n, 3) array_like of int, optional
        Multiples of the vectors of the cell, to be added to the centres of the others.

    Returns
    -------
    bool

    Raises
    ------
    PW85Error
        A pair that no overlap precedes is bad, an index is out of range, the cell is singular, or nearest images do not decide.
    ValueError
        Shapes do not match.

    Examples
    --------
    >>> import numpy as np, pypw85
    >>> q = np.array([pypw85.spheroid(1, 1, [0, 0, 1])] * 3)
    >>> centers = np.array([[0.0, 0, 0], [3, 0, 0], [9, 0, 0]])
    >>> cell = 10 * np.eye(3)
    >>> pypw85.overlap_any_indices(centers[0], q[0], [1, 2], centers, q, cell=cell)
    True
    """
    others = np.asarray(indices)
    if others.size == 0:
        others = np.empty(0, np.int32)
    if others.ndim != 1 or others.dtype.kind not in "iu":
        raise ValueError("indices must be a row of integers")
    one, form = _rows(np.asarray(center)[np.newaxis], 3, "center"), _rows(np.asarray(q1)[np.newaxis], 6, "q1")
    status, overlap = _core.overlap_any_indices(
        one,
        form,
        _int32(others, "indices"),
        *_particles(centers, q),
        _cell(cell),
        _images(images, len(others), cell is not None),
    )
    if status:
        raise PW85Error(status, "overlap_any_indices", _core.strerror(status),
                        _blame(others, one, form, *_particles(centers, q), _cell(cell)))  # fmt: skip
    return bool(overlap)


def _blame(
    indices: NDArray[Any], center: Floats, q1: Floats, centers: Floats, q: Floats, cell: Floats | None
) -> str:
    """Says what is wrong with the arguments of overlap_any_indices(). A row is one of `indices`."""
    outside = (indices < 0) | (indices >= len(centers))
    if outside.any():
        row = int(outside.argmax())
        return f"row ({row},): indices has {indices[row]}, but there are {len(centers)} particles"
    singular = "" if cell is None else explain_values("cell_reduce", (cell,))
    return singular or explain_values("overlap", (centers[indices] - center, q1, q[indices]))


def overlap_any(q1: ArrayLike, r12: ArrayLike, q2: ArrayLike) -> bool:
    """Whether an ellipsoid overlaps any of n others. Tests one after the other, up to the first overlap.

    Parameters
    ----------
    q1 : (6) array_like
        Form of the one.
    r12 : (n, 3) array_like
        Centres of the others, relative to that of the one.
    q2 : (n, 6) array_like
        Their forms.

    Returns
    -------
    bool

    Raises
    ------
    PW85Error
        A pair that no overlap precedes is bad.
    ValueError
        Shapes do not match.

    Examples
    --------
    >>> import numpy as np, pypw85
    >>> q = np.array([pypw85.spheroid(1, 1, [0, 0, 1])] * 2)
    >>> pypw85.overlap_any(q[0], [[3, 0, 0], [0, 1.5, 0]], q)
    True
    """
    form = _rows(np.asarray(q1)[np.newaxis], 6, "q1")
    separations, forms = _rows(r12, 3, "r12"), _rows(q2, 6, "q2")
    if len(separations) != len(forms):
        raise ValueError(f"{len(separations)} separations, but {len(forms)} forms")
    status, overlap = _core.overlap_any(form, separations, forms)
    if status:
        detail = explain_values("overlap", (separations, form, forms))
        raise PW85Error(status, "overlap_any", _core.strerror(status), detail)
    return bool(overlap)


def nearest_image_limit(q: ArrayLike, cell: ArrayLike) -> float:
    """Up to which μ² nearest images are all there is: any image of a pair with a smaller μ² is the nearest one.

    Where the limit is 1 or more, `overlap_pairs` with nearest images misses no overlap; a smaller μ² from `contact_pairs`
    than the limit is the smallest of all images. In a rectangular cell, the limit is at least 1 where no bounding box is
    wider than half the cell.

    Parameters
    ----------
    q : (n, 6) array_like
        Forms of the particles.
    cell : (3, 3) array_like
        Rows are the vectors of the periodic cell.

    Returns
    -------
    float

    Raises
    ------
    PW85Error
        A form is bad, or the cell is singular or not finite.

    Examples
    --------
    >>> import numpy as np, pypw85
    >>> pypw85.nearest_image_limit([pypw85.spheroid(1, 2, [0, 0, 1])], 8 * np.eye(3))
    1.0
    """
    rows = _cell(cell)
    forms = _rows(q, 6, "q")
    status, limit = _core.nearest_image_limit(forms, rows)
    if status:
        detail = explain_values("bounding_boxes", (forms,)) or explain_values("cell_reduce", (rows,))
        raise PW85Error(status, "nearest_image_limit", _core.strerror(status), detail)
    return float(limit)
