# SPDX-License-Identifier: BSD-3-Clause
"""Averages over correlated samples, with errors by blocking."""

from __future__ import annotations

import itertools
import statistics
from typing import Any, NamedTuple
from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._arrays import reals
from ._numbers import integer
from ._typing import Floats

# The three longest lengths of blocks are used of which there are at least this many: 8 to 15, 16 to 31, and 32 to 63 blocks.
_LEAST_BLOCKS, _LENGTHS = 8, 3
# The largest of five estimates is too large for independent samples: the mean of z², the squared deviation of an average over its
# squared error, would be 0.74. With this factor it is 0.87, and 0.9 to 1.1 for samples that are correlated over 0.5 to 5 % of a run.
_FACTOR = 0.85
# A run is too short if its samples are correlated over more than this part of it.
_LONGEST_TIME = 1 / 8
# An error from m independent blocks has itself the relative error 1/√(2 (m - 1)): 18 % for 16. A deviation over it has the mean square
# (m - 1)/(m - 3) of Student's t: 1.15. Least numbers of independent samples of a number, and of its 48 to 95 blocks, counted
# without the correlation that is left between them: those of the shortest of the three longest lengths of which there are at least 12. With
# 8 in place of 12 there are 32 to 63 blocks. Of 32, white noise has too few in a quarter of all runs, and of 63 hardly ever.
LEAST_INDEPENDENT, _LEAST_TO_RESOLVE = 16, 12
# Samples of more numbers, or of one, have no slowest number that tells of others.
_MOST_RELATED = 16
# Of all runs without a drift, this part is said to drift.
_FALSE_ALARMS = 0.05
# A run that drifts by t errors of the difference, which is √12 times the error σ of the mean, averages half of it away from its end, which
# is √3 t σ. With the squared error σ² (1 + 5 t²), and t from a straight line, the root mean square of deviations from the end is at most
# 1.23 for a drift of any size, if t is Gaussian: it is the root of the largest (1 + 3 m²) <1/(1 + 5 t²)>, where t has the mean m and the
# variance 1. With 3 t² it would be 1.42, and with 4 t² 1.31. The errors of correlated samples are less certain than a Gaussian t.
_DRIFT = 5.0
# The extrapolation of a correlation that is nearly one has no end.
_LARGEST_CORRELATION = 0.95


class Estimate(NamedTuple):
    """An average with its standard error, from correlated samples.

    `value` is the average, `error` its standard error, and `samples` the number of independent samples that would have the same error.
    `error` and `samples` are NaN if the run is too short compared with the correlation time.
    """

    value: Any
    error: Any
    samples: Any


class Blocking:
    """Averages of numbers that come one after the other and may be correlated.

    The samples are averaged in pairs, these averages in pairs again, and so on. While blocks are short, their averages are correlated, and
    the error that they give for the mean is too small. It grows with the length of the blocks until they are independent (Flyvbjerg
    and Petersen, J. Chem. Phys. 91, 461, 1989). The error is taken from the three longest lengths of which there are eight blocks or
    more: the largest of their errors, and of what these become if the correlation of successive blocks decays exponentially. All numbers
    of a sample have the same blocks, and the part that one of them shares with the slowest one is extrapolated in the same way, for
    samples of 2 to 16 numbers. If one of them is correlated over more than an eighth of the run, the run is too short for all of them,
    and the errors are NaN, as for fewer than 32 samples. `resolved` is stricter. The manual has the derivation (Monte Carlo, "Averages
    and their errors"). The memory grows with the logarithm of the number of samples.

    Parameters
    ----------
    size : int
        Number of numbers in a sample.

    Examples
    --------
    >>> import numpy as np, pypw85
    >>> averages = pypw85.Blocking()
    >>> for number in np.random.default_rng(1).normal(size=1000):
    ...     averages.add(number)
    >>> found = averages.estimate()
    >>> bool(abs(found.value[0]) < 0.1)
    True
    >>> bool(0.02 < found.error[0] < 0.05)  # 1/√1000 = 0.032 if it were known exactly
    True
    """

    __slots__ = ("_counts", "_means", "_pending", "_products", "_squares", "_tilts", "size")

    def __init__(self, size: int = 1) -> None:
        self.size = integer(size, "Blocking: size", 1, 2**31 - 1)
        # By the logarithm of the length of blocks: how many there were, their mean, the sum of squares of deviations from it, that of
        # products of these and the numbers of the blocks, and the last block if it has no partner yet.
        self._counts: list[int] = []
        self._means: list[Floats] = []
        self._squares: list[Floats] = []
        self._tilts: list[Floats] = []
        # By the same, sums of products of deviations of any two numbers, if there are some, behind the size
        self._products: list[Floats] = []
        self._pending: list[Floats] = []

    def __len__(self) -> int:
        """Number of samples."""
        return self._counts[0] if self._counts else 0

    def add(self, sample: ArrayLike) -> None:
        """Adds the next sample.

        Parameters
        ----------
        sample : (size) array_like
            If one of the numbers is NaN in any sample, its average is NaN.
        """
        block, level = reals(sample, "Blocking.add: sample").copy(), 0
        if block.size != self.size:
            raise ValueError(f"Blocking.add: the shape of the sample must be ({self.size},), not {block.shape}")
        block = block.reshape(self.size)
        while True:
            self._count(level, block)
            if self._counts[level] % 2:
                self._pending[level] = block
                return
            block, level = (self._pending[level] + block) / 2, level + 1

    def _rows(self) -> tuple[list[Floats], ...]:
        return self._means, self._squares, self._tilts, self._pending

    def _count(self, level: int, block: Floats) -> None:
        if level == len(self._counts):
            self._counts.append(0)
            for rows in self._rows():
                rows.append(np.zeros(self.size))
            self._products.append(np.zeros(_num_products(self.size)))
        self._counts[level] += 1
        deviation = block - self._means[level]
        self._tilts[level] = self._tilts[level] + (self._counts[level] - 1) / 2 * deviation
        self._means[level] = self._means[level] + deviation / self._counts[level]
        remaining = block - self._means[level]
        self._squares[level] = self._squares[level] + deviation * remaining
        if self._products[level].size:
            sums = self._products[level][1:] + np.outer(deviation, remaining).ravel()
            self._products[level] = np.concatenate([[self.size], sums])

    def estimate(self) -> Estimate:
        """Averages with standard errors that are valid if there is no drift.

        Returns
        -------
        Estimate
            Its members are arrays (size).
        """
        mean = self._means[0].copy() if len(self) else np.full(self.size, np.nan)
        error, samples = self.errors(self.squared_error)
        if self.too_slow().any():
            error, samples = np.full((2, self.size), np.nan)
        elif self._products[0].size:
            shared = np.sqrt(self._error_by_slowest(error**2))
            factor = np.divide(shared, error, out=np.ones(self.size), where=shared > error)
            error, samples = error * factor, samples / factor**2
        return Estimate(mean, error, samples)

    def cautious(self) -> Estimate:
        """The averages, with errors that allow for a drift and for their own uncertainty.

        A small drift cannot be distinguished from no drift. Therefore the squared error grows by the factor 1 + 5 t², with the drift t of
        `drifts`. An error from n independent samples has itself the relative error 1/√(2 (n - 1)); this is added, with n of the slowest
        number.

        Returns
        -------
        Estimate
            Its members are arrays (size).
        """
        value, error, samples = self.estimate()
        known = samples[~np.isnan(samples) & (error > 0)]
        slowest = known.min() if known.size else np.inf
        return Estimate(value, error * widening(slowest, self.drifts()), samples)

    def resolved(self) -> NDArray[np.bool_]:
        """Returns which numbers have enough independent samples for an error that is itself known to about 20 %.

        A number needs 16 independent samples, also if only 48 to 95 blocks of samples are considered. Thus the run is long compared
        with its slowest fluctuation, which may be hidden by faster fluctuations with a larger variance.

        Returns
        -------
        (size) array of bool
            False for fewer than 48 samples, and for numbers that are NaN.
        """
        levels = self._levels(_LEAST_TO_RESOLVE)
        if not levels:
            return np.zeros(self.size, dtype=bool)
        error, samples = self._errors(self.squared_error, levels)
        independent = self._counts[levels[0]] * _FACTOR * self.squared_error(levels[0])
        enough = independent >= LEAST_INDEPENDENT * error**2
        result: NDArray[np.bool_] = enough & (samples >= LEAST_INDEPENDENT) & ~self.too_slow()
        return result

    def _error_by_slowest(self, squared: Floats) -> Floats:
        """The squared errors by the shortest blocks, in which the part that goes with the slowest number is enlarged as that of it is. The
        part is the squared correlation of their blocks, less what it is by chance."""
        levels = self._levels()
        squares = [self.squared_error(level) for level in levels]
        r = _correlations(squares)[0]
        slowest, m = int(np.argmax(np.where(np.isnan(r), -np.inf, r))), self._counts[levels[0]]
        products = self._products[levels[0]][1:].reshape(self.size, self.size)
        norm = np.diagonal(products) * products[slowest, slowest]
        part = np.divide(products[slowest] ** 2, norm, out=np.zeros(self.size), where=norm > 0)
        part = np.maximum(1 - (1 - part) * (m - 1) / (m - 2), 0)
        own = _FACTOR * squares[0]
        growth = squared[slowest] / own[slowest] if own[slowest] > 0 else 1.0
        result: Floats = own * (1 + part * max(growth - 1, 0.0))
        return result

    def drifts(self) -> Floats:
        """Drifts: the change along a fitted straight line from the first sample to the last, divided by its standard error.

        Returns
        -------
        (size) array
            About 1 or less if there is no drift; NaN for fewer than 32 samples.
        """
        error, n = self.errors(self._squared_error_about_line)[0], len(self)
        if not n:
            return error
        # The slope is the sum of products over n³/12. Its error over the run is √12 times that of the mean.
        difference = 12 * self._tilts[0] / n**2
        with np.errstate(divide="ignore"):
            result: Floats = np.divide(difference, np.sqrt(12) * error, out=np.zeros(self.size), where=difference != 0)
        return result

    def _squared_error_about_line(self, level: int) -> Floats:
        """As `squared_error`, with deviations from a straight line instead of the mean."""
        m = self._counts[level]
        squares = self._squares[level] - 12 * self._tilts[level] ** 2 / (m * (m * m - 1))
        result: Floats = np.maximum(squares, 0) / (m * (m - 2))
        return result

    def squared_error(self, level: int) -> Floats:
        """The squared standard error of the mean if blocks of 2**level samples were independent."""
        count = self._counts[level]
        result: Floats = self._squares[level] / (count * (count - 1))
        return result

    def _levels(self, least: int = _LEAST_BLOCKS) -> list[int]:
        """The three longest lengths that have at least `least` blocks; none if there are too few samples."""
        enough = [level for level, count in enumerate(self._counts) if count >= least]
        return enough[-_LENGTHS:] if len(enough) >= _LENGTHS else []

    def errors(self, squared_error: Callable[[int], Floats]) -> tuple[Floats, Floats]:
        """Standard errors and numbers of independent samples of averages, whose squared errors are given as by `squared_error`."""
        levels = self._levels()
        if not levels:
            unknown = np.full_like(self._means[0] if len(self) else np.empty(self.size), np.nan)
            return unknown, unknown
        return self._errors(squared_error, levels)

    def _errors(self, squared_error: Callable[[int], Floats], levels: list[int]) -> tuple[Floats, Floats]:
        """As `errors`, by blocks of these lengths."""
        squares = [squared_error(level) for level in levels]
        extrapolated = []
        for square, r in zip(squares, _correlations(squares)):
            r = np.clip(r, 0, _LARGEST_CORRELATION)
            extrapolated.append(square * (1 + r) / (1 - r))
        largest = _FACTOR * np.max([*squares, *extrapolated], axis=0)
        # If all samples are equal, the errors are 0, as for independent samples.
        independent = squared_error(0)
        growth = np.divide(largest, independent, out=np.ones_like(largest), where=independent != 0)
        return np.sqrt(largest), len(self) / growth

    def too_slow(self) -> NDArray[np.bool_]:
        """Marks the numbers that are correlated over too long a part of the run for an error; all if there are few samples."""
        levels = self._levels()
        if not levels:
            return np.ones(self.size, dtype=bool)
        r = _correlations([self.squared_error(level) for level in levels])[0]
        slow: NDArray[np.bool_] = r > _block_correlation(1 / (_LONGEST_TIME * self._counts[levels[0]]))
        return slow

    def state(self) -> Floats:
        """All numbers of this object as an array for `restore`, one row for each length of blocks."""
        rows = [np.concatenate([[count], *parts]) for count, *parts in zip(self._counts, *self._rows(), self._products)]
        return np.array(rows).reshape(len(rows), _width(self.size))

    @classmethod
    def restore(cls, state: ArrayLike) -> Blocking:
        """Makes an object from the result of `state`. It continues the saved averages with bitwise equal results.

        Parameters
        ----------
        state : array_like
            From `state`.

        Returns
        -------
        Blocking
        """
        width = np.shape(state)[-1] if np.ndim(state) == 2 else 0
        made = cls(next((size for size in range(1, width) if _width(size) == width), 1))
        made._take(state)
        return made

    def _take(self, state: ArrayLike) -> None:
        """Continues what has a state of this size."""
        rows = np.array(state, dtype=np.float64)
        counts = rows[:, 0] if rows.ndim == 2 and rows.shape[1] == _width(self.size) else np.array([np.nan])
        first = counts[0] if len(counts) else 0
        if not (len(counts) < 64 and all(count >= 1 and count == first // 2**k for k, count in enumerate(counts))):
            raise ValueError(f"Blocking.restore: the state must be that of state() for samples of {self.size} numbers")
        self._counts = [int(count) for count in counts]
        for k, parts in enumerate(self._rows()):
            parts[:] = rows[:, 1 + k * self.size : 1 + (k + 1) * self.size].copy()
        self._products = list(rows[:, 1 + 4 * self.size :].copy())


def widening(samples: ArrayLike, drifts: ArrayLike) -> Floats:
    """The factor of errors for a number of independent samples, in a run with a given drift."""
    own = 1 / np.sqrt(2 * (np.maximum(samples, 2) - 1))
    result: Floats = (1 + own) * np.sqrt(1 + _DRIFT * np.square(drifts))
    return result


def largest_drift(numbers: int) -> float:
    """The drift that one of a number of independent numbers exceeds in 5 % of all runs without a drift."""
    return statistics.NormalDist().inv_cdf((1 + (1 - _FALSE_ALARMS) ** (1 / max(numbers, 1))) / 2)


def _num_products(size: int) -> int:
    return 1 + size * size if 1 < size <= _MOST_RELATED else 0


def _width(size: int) -> int:
    """Of the rows of a state. It is 1 more than a multiple of 4 without products, and 2 or 3 more with them, so each size has its own."""
    return 1 + 4 * size + _num_products(size)


def _correlations(squares: list[Floats]) -> list[Floats]:
    """Correlations of successive blocks, for squared errors by blocks each of which are twice as long as those before."""
    found: list[Floats] = []
    for square, twice in itertools.pairwise(squares):
        ratio: Floats = np.divide(twice, square, out=np.ones_like(twice), where=square != 0)
        found.append(ratio - 1.0)
    return found


def _block_correlation(length: float) -> float:
    """The correlation of the averages of successive blocks of this length if correlations decay by e over the length 1."""
    decay = -np.expm1(-length)
    return float(decay**2 / (2 * (length - decay)))
