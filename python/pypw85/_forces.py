# SPDX-License-Identifier: BSD-3-Clause
"""Derivatives of the contact function of the pairs of a list, and the forces and torques of a pair energy."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from ._device import apply_to_pairs, is_device_array
from ._functions import ContactDerivatives
from ._arrays import reals
from ._numbers import instance, integer, real
from ._pairs import _cell, _pair_list, _rows, check_list
from ._typing import Floats


class ContactForces(NamedTuple):
    """Result of `contact_forces_pairs` for N particles.

    `forces` (N, 3) and `torques` (N, 3) are those on the particles, the torques about their centres. `virial` (3, 3) is Σ r12 ⊗ f12 over
    the pairs, where f12 is the force on the second particle of the pair.
    """

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
    """Computes μ², its derivatives, contact points and normals of the pairs of a list; see `contact_derivatives`.

    Parameters
    ----------
    pairs, centers, q, cell, images
        As for `contact_pairs`.

    Returns
    -------
    ContactDerivatives
        Arrays with one row for each pair; NaN for an invalid pair. NumPy then warns, or does what ``np.errstate(invalid=...)`` selects.

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
    n = len(arrays.pairs)
    result = ContactDerivatives(np.empty(n), np.empty(n), *(np.empty((n, 3)) for _ in range(5)))
    status = _core.contact_derivatives_pairs(*arrays, *result)
    check_list(status, "contact_derivatives_pairs", arrays)
    return result


def contact_forces_pairs(
    pairs: ArrayLike,
    centers: ArrayLike,
    d_u: ArrayLike,
    derivatives: ContactDerivatives,
    cell: ArrayLike | None = None,
    images: ArrayLike | None = None,
) -> ContactForces:
    """Computes the forces, torques and virial of a pair energy U(μ²) by summing over the pairs of a list.

    Parameters
    ----------
    pairs, centers, cell, images
        As for `contact_pairs`.
    d_u : (n) array_like
        dU/dμ² of each pair. If it is 0, the pair contributes nothing, even if its derivatives are NaN.
    derivatives : ContactDerivatives
        Result of `contact_derivatives_pairs`.

    Returns
    -------
    ContactForces
        The results are bitwise equal for any number of threads.

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
    n, num_particles = len(arrays.pairs), len(arrays.centers)
    slopes = np.require(reals(d_u, "d_u"), np.float64, ["C", "A"])
    if slopes.shape != (n,):
        raise ValueError(f"the shape of d_u must be ({n},), not {slopes.shape}")
    rows = [_rows(getattr(derivatives, name), 3, name) for name in ("d_r12", "d_rot1", "d_rot2")]
    if any(len(array) != n for array in rows):
        raise ValueError(f"the derivatives must have {n} rows, one for each pair")
    forces, torques = np.empty((num_particles, 3)), np.empty((num_particles, 3))
    given = (one for name, one in arrays._asdict().items() if name != "q")
    status, virial = _core.contact_forces_pairs(*given, slopes, *rows, forces, torques)
    check_list(status, "contact_forces_pairs", arrays)
    return ContactForces(forces, torques, np.reshape(virial, (3, 3)))


class Law(NamedTuple):
    """A law: the energy U of a pair as a function of μ², for `law_forces_pairs` and `HardEllipsoids.set_law`.

    Make laws by `Law.soft_repulsion`, `Law.inverse_powers` and `Law.table`. U is in any unit of energy; for simulations, in units of k_B T.
    """

    kind: int
    parameters: Floats

    @classmethod
    def soft_repulsion(cls, energy: float, exponent: float = 2.0) -> Law:
        """Makes a soft repulsion: U = energy/exponent (1 - μ)**exponent for μ < 1, and U = 0 for μ >= 1.

        Parameters
        ----------
        energy : float
            Energy scale; U at μ = 0 is energy/exponent.
        exponent : float
            At least 1; 2 for a harmonic repulsion, 2.5 for a Hertzian one.

        Returns
        -------
        Law
        """
        return cls(1, _parameters("soft_repulsion", energy=energy, exponent=exponent))

    @classmethod
    def inverse_powers(
        cls, repulsion: float, n: float, attraction: float, m: float, mu2_max: float = float(np.finfo(float).max)
    ) -> Law:
        """Makes a law of powers of 1/μ: U = repulsion μ**-n - attraction μ**-m - U_c for μ² < `mu2_max`, and U = 0 beyond this cutoff.

        The constant U_c makes U continuous at the cutoff.

        Parameters
        ----------
        repulsion, attraction : float
            Prefactors, in the unit of energy. For a well of depth ε use 4ε and 4ε with n = 12 and m = 6.
        n, m : float
            Exponents, n > m > 0.
        mu2_max : float
            The cutoff, a value of μ². By default there is no cutoff. `HardEllipsoids.set_law` needs one above 1 and at most 10**6.

        Returns
        -------
        Law
        """
        return cls(2, _parameters("inverse_powers", repulsion=repulsion, n=n, attraction=attraction, m=m, mu2_max=mu2_max))

    @classmethod
    def table(cls, mu2_min: float, mu2_max: float, u: ArrayLike, d_u: ArrayLike) -> Law:
        """Makes a law from a table of U and dU/dμ² at equally spaced values of μ². Between these points U is a cubic polynomial.

        Parameters
        ----------
        mu2_min, mu2_max : float
            First and last value of μ². Below `mu2_min`, U is linear in μ²; from `mu2_max` on, U is 0.
        u, d_u : (n) array_like
            U and dU/dμ² at n >= 2 values of μ².

        Returns
        -------
        Law
        """
        energies, slopes = reals(u, "Law.table: u"), reals(d_u, "Law.table: d_u")
        if energies.ndim != 1 or energies.shape != slopes.shape:
            raise ValueError("Law.table: u and d_u must be one-dimensional and of the same length, "
                             f"not of the shapes {energies.shape} and {slopes.shape}")  # fmt: skip
        points = np.stack([energies, slopes], axis=1)
        return cls(3, np.concatenate([_parameters("table", mu2_min=mu2_min, mu2_max=mu2_max), points.ravel()]))


def _parameters(name: str, **numbers: float) -> Floats:
    return np.array([real(number, f"Law.{name}: {argument}") for argument, number in numbers.items()])


def checked_law(law: object, name: str) -> Law:
    """Checks the types of a law: an integer and a one-dimensional array. The library checks the values."""
    given = instance(law, Law, name)
    parameters = reals(given.parameters, f"{name}: parameters")
    if parameters.ndim != 1:
        raise ValueError(f"{name}: parameters must be a row of numbers, not an array of the shape {parameters.shape}")
    return Law(integer(given.kind, f"{name}: kind", 1, 3), parameters)


class LawForces(NamedTuple):
    """Result of `law_forces_pairs` for N particles.

    `energy` is the total energy of all pairs. `forces` (N, 3), `torques` (N, 3) and `virial` (3, 3) are as for `contact_forces_pairs`.
    """

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
    """Computes the total energy, the forces, the torques and the virial of the pairs of a list, for a pair energy U(μ²).

    The call takes little more time than `contact_derivatives_pairs`.

    Parameters
    ----------
    pairs, centers, q, cell, images
        As for `contact_pairs`.
    law : Law
        The energy of a pair.

    Returns
    -------
    LawForces
        Sums to which an invalid pair contributes are NaN; NumPy then warns, or does what
        ``np.errstate(invalid=...)`` selects. The results are bitwise equal for any number of threads.

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
    num_particles = len(arrays.centers)
    law = checked_law(law, "law_forces_pairs: law")
    parameters = np.require(law.parameters, np.float64, ["C", "A"])
    forces, torques = np.empty((num_particles, 3)), np.empty((num_particles, 3))
    status, energy, virial = _core.law_forces_pairs(*arrays, law.kind, parameters, forces, torques)
    check_list(status, "law_forces_pairs", arrays, num_parameters=len(parameters), parameters=parameters)
    return LawForces(energy, forces, torques, np.reshape(virial, (3, 3)))
