# SPDX-License-Identifier: BSD-3-Clause
"""Averages over a simulation of hard ellipsoids, with errors."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from ._blocking import Blocking, Estimate, largest_drift
from ._numbers import instance, integer, real
from ._pairs import contact_pairs
from ._simulations import HardEllipsoids, is_bulk
from ._statistics import (
    PairCorrelation,
    check_width,
    compressibility_of,
    count_pairs,
    largest_order,
    main_direction,
    nematic_tensor,
    principal_directions,
)
from ._system import System
from ._typing import Floats

# Rows and columns of the upper triangle of a symmetric matrix
_UPPER = np.triu_indices(3)
# If a bias is proportional to the fourth power of a width, the values for a width and for half of it differ by 15/16 of the bias.
_BIAS_BY_DIFFERENCE = 16 / 15
# Each bin takes 8 numbers at each of some twenty lengths of blocks.
MOST_BINS = 10**6
# What `Observables` averages, apart from each other: directors turn slowly where nothing holds them, which says nothing of pressures.
_BLOCKINGS = ("values", "tensors", "pairs")


class Sample(NamedTuple):
    """The numbers of one configuration, as `Observables` defines them; NaN if one is not defined.

    They are `volume`, `density`, `packing_fraction`, `nematic_order`, `compressibility_chains`, `compressibility_contacts`,
    `contacts_bias` and `energy`.
    """

    volume: float
    density: float
    packing_fraction: float
    nematic_order: float
    compressibility_chains: float
    compressibility_contacts: float
    contacts_bias: float
    energy: float


class Observables:
    """Averages over a simulation of hard ellipsoids, with standard errors by `Blocking`.

    Call `add` after every few sweeps, and `estimates` at the end. The memory does not grow with the number of samples. The averages are

    - ``volume`` of the cell, ``density`` (particles per volume) and ``packing_fraction``; in two dimensions, area replaces volume;
    - ``nematic_order``, as computed by `pypw85.nematic_order`. Without order it is not 0, but about 1/√N;
    - ``compressibility_chains``, βP/ρ from event chains;
    - ``compressibility_contacts``, βP/ρ from the pairs that nearly touch, as computed by `pypw85.compressibility`, plus the virial of the
      law of pairs, if there is one (`HardEllipsoids.law_virial`). The error is the statistical one, without the bias;
    - ``contacts_bias``, an estimate of the bias of ``compressibility_contacts`` that comes from the extrapolation to contact. If it
      exceeds its error, use a smaller `width`. If no pair was within the width, ``contacts_bias`` has no error, and without a law
      ``compressibility_contacts`` has none either: use a larger `width`;
    - ``energy``, βU of all particles in the fields and the potential, and of all pairs by their law; 0 without these.

    If the cell is not periodic along all its vectors (a system in a container), only ``nematic_order`` and ``energy`` are defined.

    Parameters
    ----------
    width : float
        Width of the interval of μ - 1 from which the pressure is extrapolated to contact, > 0 and at most 1.
    reach : float
        Largest distance of the pair correlation; 0 for no pair correlation. It may exceed the cell, because all images count.
    bins : int
        Number of bins of the pair correlation, at most 10**6.

    Raises
    ------
    ValueError
        An argument is out of range.

    Examples
    --------
    >>> import numpy as np, pypw85
    >>> start = pypw85.pack(np.tile([0.5, 0.5, 1], (50, 1)), 0.3, seed=1)
    >>> simulation = pypw85.HardEllipsoids(start, seed=1)
    >>> simulation.tune(20)
    >>> observables = pypw85.Observables(reach=2.0)
    >>> for _ in range(200):
    ...     simulation.sweep()
    ...     sample = observables.add(simulation, simulation.chain(2, 3.0))
    >>> found = observables.estimates()
    >>> bool(abs(found["packing_fraction"].value - 0.3) < 1e-12)
    True
    >>> bool(3 < found["compressibility_chains"].value < 6)
    True
    >>> observables.pair_correlation().g.shape
    (50,)
    """

    __slots__ = ("_bins", "_pairs", "_reach", "_tensors", "_values", "_width")

    def __init__(self, width: float = 0.1, reach: float = 0.0, bins: int = 50) -> None:
        self._width, self._reach = real(width, "Observables: width"), real(reach, "Observables: reach")
        self._bins = integer(bins, "Observables: bins", 1, MOST_BINS)
        check_width("Observables", self._width)
        if not 0 <= self._reach < np.inf:
            raise ValueError(f"Observables: reach must be >= 0 and finite, not {reach}")
        self._values, self._tensors = Blocking(len(Sample._fields)), Blocking(len(_UPPER[0]))
        self._pairs = Blocking(4 * self._bins)

    @property
    def width(self) -> float:
        """Width of the interval of μ - 1 from which the pressure is extrapolated to contact."""
        return self._width

    def __len__(self) -> int:
        """Number of samples."""
        return len(self._values)

    def add(self, simulation: HardEllipsoids, compressibility: float | None = np.nan) -> Sample:
        """Adds a sample: the present state of the simulation.

        Parameters
        ----------
        simulation : HardEllipsoids
            If its cell is not periodic along all its vectors, volume, density, packing fraction and pressure are NaN.
        compressibility : float, optional
            Result of `HardEllipsoids.chain`. Without it, ``compressibility_chains`` is NaN.

        Returns
        -------
        Sample
            The numbers of this configuration.

        Raises
        ------
        ValueError
            There are no particles; or `reach` is not 0, and the cell is not periodic along all its vectors.
        PW85Error
            The simulation was restored, and its potential is not set.
        """
        system = instance(simulation, HardEllipsoids, "Observables.add: simulation").system()
        of_chains = np.nan if compressibility is None else real(compressibility, "Observables.add: compressibility")
        if not len(system):
            raise ValueError("Observables.add: the simulation must have particles")
        if self._reach > 0 and not is_bulk(system):
            vectors = "three" if system.dimensions == 3 else "two"
            raise ValueError(f"Observables.add: a pair correlation needs a cell that is periodic along its {vectors} vectors: "
                             "leave out reach")  # fmt: skip
        directions = principal_directions(system)
        tensor = nematic_tensor(directions, system.dimensions)
        volume, fraction = system.volume, system.packing_fraction
        if not is_bulk(system) or volume is None or fraction is None:
            volume = fraction = np.nan
        wide, narrow = self._from_contacts(system) if is_bulk(system) else (np.nan, np.nan)
        of_law = simulation.law_virial() / (system.dimensions * len(system))  # in βP/ρ
        sample = Sample(
            volume=volume,
            density=len(system) / volume,
            packing_fraction=fraction,
            nematic_order=largest_order(tensor),
            compressibility_chains=of_chains,
            compressibility_contacts=wide + of_law,
            contacts_bias=_BIAS_BY_DIFFERENCE * (wide - narrow),
            energy=simulation.energy(),
        )
        self._values.add(sample)
        self._tensors.add(tensor[_UPPER])
        if self._reach > 0:
            self._pairs.add(count_pairs(system, directions, self._edges()).ravel())
        return sample

    def _from_contacts(self, system: System) -> tuple[float, float]:
        """βP/ρ from the pairs that nearly touch, by extrapolation over the width and over half of it."""
        found = system.neighbors(1 + self._width)
        mu2 = contact_pairs(found.pairs, system.centers, system.q, system.cell, images=found.images)[0]
        excess = np.maximum(np.sqrt(mu2) - 1, 0)  # rounding errors may take a pair that touches below 0
        wide, narrow = (compressibility_of(excess, len(system), width, system.dimensions) for width in (self._width, self._width / 2))
        return wide, narrow

    def _edges(self) -> Floats:
        return np.linspace(0, self._reach, self._bins + 1, dtype=np.float64)

    def estimates(self) -> dict[str, Estimate]:
        """Averages with cautious standard errors (`Blocking.cautious`), which allow for a drift.

        Returns
        -------
        dict of Estimate
            By the names above. A quantity without a value is left out.
        """
        return self._named(self._values.cautious())

    def stationary(self) -> dict[str, Estimate]:
        """Averages with the standard errors of `Blocking.estimate`, which are valid only if the run does not drift.

        Returns
        -------
        dict of Estimate
            By the names above. A quantity without a value is left out.
        """
        return self._named(self._values.estimate())

    def _named(self, found: Estimate) -> dict[str, Estimate]:
        value, error, samples = found
        contacts = [Sample._fields.index(name) for name in ("compressibility_contacts", "contacts_bias")]
        unseen = [place for place in contacts if error[place] == 0]  # no pair was ever within the width
        error[unseen] = samples[unseen] = np.nan
        columns = zip(value.tolist(), error.tolist(), samples.tolist())
        return {name: Estimate(*row) for name, row in zip(Sample._fields, columns) if not np.isnan(row[0])}

    def drifts(self) -> dict[str, float]:
        """Drifts of the averages over the run, in units of their standard errors (`Blocking.drifts`).

        Returns
        -------
        dict of float
            By the names of the averages. An average without an error is left out.
        """
        return {name: drift for name, drift in zip(Sample._fields, map(float, self._values.drifts())) if not np.isnan(drift)}

    def drifting(self) -> dict[str, float]:
        """Drifts that are probably not due to chance. Of all runs without a drift, 5 % have one here.

        Returns
        -------
        dict of float
            As for `drifts`; empty if no average drifts.
        """
        found = self.drifts()
        largest = largest_drift(sum(drift != 0 for drift in found.values()))
        return {name: drift for name, drift in found.items() if abs(drift) > largest}

    def unsettled(self) -> list[str]:
        """Names of the averages that drift, or whose samples are correlated over more than an eighth of the run.

        Such a correlation may be a drift of another form. With fewer than 32 samples, all names are returned.
        """
        drifting, slow = self.drifting(), dict(zip(Sample._fields, self._values.too_slow().tolist()))
        return [name for name in self.estimates() if slow[name] or name in drifting]

    def unresolved(self) -> list[str]:
        """Names of the averages that have too few independent samples for a standard error (`Blocking.resolved`).

        If there is one, do not trust the errors of the other averages either: these may follow the slow one, and noise may hide that.
        """
        resolved = dict(zip(Sample._fields, self._values.resolved().tolist()))
        return [name for name in self.estimates() if not resolved[name]]

    def director(self) -> Floats:
        """Director of all samples: the main eigenvector of the mean of 3/2 <u uᵀ> - 1/2, with the sign of `pypw85.director`.

        Returns
        -------
        (3,) array
            NaN without samples, and for spheres.
        """
        tensor = np.empty((3, 3))
        tensor[_UPPER] = tensor.T[_UPPER] = self._tensors.estimate().value
        return main_direction(tensor) if len(self) else np.full(3, np.nan)

    def pair_correlation(self) -> PairCorrelation | None:
        """Pair correlation as a function of distance, averaged over the samples.

        Returns
        -------
        PairCorrelation or None
            None without samples, or if `reach` is 0.
        """
        if not len(self._pairs):
            return None
        mean, axial, weighted_mean, _ = self._pairs.estimate().value.reshape(4, self._bins)
        p2 = np.divide(weighted_mean, axial, out=np.full(self._bins, np.nan), where=axial != 0)

        def squared_error_of_p2(level: int) -> Floats:
            """Error of the numbers weighted - p2 counts, whose mean is 0, over the mean of counts, both of pairs with axes."""
            _, counts, weighted, both = self._pairs.squared_error(level).reshape(4, self._bins)
            squared = weighted + p2**2 * counts - p2 * (both - counts - weighted)
            result: Floats = np.maximum(squared, 0) / np.where(axial != 0, axial, np.nan) ** 2
            return result

        errors = [self._pairs.errors(one)[0][: self._bins] for one in (self._pairs.squared_error, squared_error_of_p2)]
        if self._values.too_slow().any():  # a pair of few particles may be there hardly ever, and does not tell
            errors = [np.full(self._bins, np.nan)] * 2
        return PairCorrelation(self._edges(), mean, errors[0], p2, errors[1])

    def state(self) -> dict[str, Floats]:
        """All numbers of this object as arrays, for `restore`."""
        settings = np.array([self._width, self._reach, self._bins])
        return {"settings": settings} | {name: getattr(self, f"_{name}").state() for name in _BLOCKINGS}

    @classmethod
    def restore(cls, state: dict[str, Floats]) -> Observables:
        """Makes an object from the result of `state`. It continues the saved averages with bitwise equal results.

        Parameters
        ----------
        state : dict of arrays
            From `state`.

        Returns
        -------
        Observables
        """
        try:
            width, reach, bins = map(float, np.asarray(state["settings"]))
            rows = [state[name] for name in _BLOCKINGS]
        except (LookupError, TypeError, ValueError):
            raise ValueError("Observables.restore: the state must be that of Observables.state()") from None
        made = cls(width, reach, int(bins))
        for name, numbers in zip(_BLOCKINGS, rows):
            getattr(made, f"_{name}")._take(numbers)
        return made
