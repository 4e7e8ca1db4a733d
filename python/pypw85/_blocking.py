"""Averages over correlated samples, with errors by blocking."""

from __future__ import annotations

import operator
from typing import Any, NamedTuple
from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike

from ._typing import Floats

# The least number of blocks for an error. With so many, the error itself has a relative standard error of 1/√14 = 27 %.
_LEAST_BLOCKS = 8


class Estimate(NamedTuple):
    """An average, its standard error, and to how many independent samples it corresponds.

    Error and samples are NaN if the samples are too few for the time over which they are correlated.
    """

    value: Any
    error: Any
    samples: Any


class Blocking:
    """Averages of numbers that come one after the other and may be correlated.

    The samples are averaged in pairs, these averages in pairs again, and so on. While blocks are short, their averages are correlated, and
    the error that they give for the mean is too small. It grows with the length of the blocks until they are independent (Flyvbjerg
    and Petersen, J. Chem. Phys. 91, 461, 1989). The error is that of the shortest blocks of B samples with B³ > 2 n (s_B/s_1)⁴,
    where n is the number of samples and s_B is the error by blocks of B (Lee and others, Phys. Rev. E 83, 066706, 2011). There must be
    eight such blocks. If correlations decay exponentially with a time t, then s_B² is too small by t/B of its value, and
    (s_B/s_1)² = 2 t. So this bias is at most a quarter of the statistical error √(2 B/n) of s_B². The memory grows with the logarithm of
    the number of samples.

    Parameters
    ----------
    size : int
        How many numbers a sample has.

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

    __slots__ = ("_counts", "_means", "_pending", "_squares", "size")

    def __init__(self, size: int = 1) -> None:
        self.size = operator.index(size)
        if self.size < 1:
            raise ValueError(f"Blocking: size is {size}: it must be at least 1")
        # By the logarithm of the length of blocks: how many there were, their mean, the sum of squares of deviations from it, and
        # the last block if it has no partner yet.
        self._counts: list[int] = []
        self._means: list[Floats] = []
        self._squares: list[Floats] = []
        self._pending: list[Floats] = []

    def __len__(self) -> int:
        """How many samples there were."""
        return self._counts[0] if self._counts else 0

    def add(self, sample: ArrayLike) -> None:
        """Takes the next sample.

        Parameters
        ----------
        sample : (size) array_like
        """
        block, level = np.array(sample, dtype=np.float64), 0
        if block.size != self.size:
            raise ValueError(f"Blocking.add: the sample has the shape {block.shape}, which should be ({self.size},)")
        block = block.reshape(self.size)
        while True:
            self._count(level, block)
            if self._counts[level] % 2:
                self._pending[level] = block
                return
            block, level = (self._pending[level] + block) / 2, level + 1

    def _count(self, level: int, block: Floats) -> None:
        if level == len(self._counts):
            self._counts.append(0)
            for rows in (self._means, self._squares, self._pending):
                rows.append(np.zeros(self.size))
        self._counts[level] += 1
        deviation = block - self._means[level]
        self._means[level] = self._means[level] + deviation / self._counts[level]
        self._squares[level] = self._squares[level] + deviation * (block - self._means[level])

    def estimate(self) -> Estimate:
        """The averages.

        Returns
        -------
        Estimate
            Of arrays (size).
        """
        mean = self._means[0].copy() if len(self) else np.full(self.size, np.nan)
        return Estimate(mean, *self.errors(self.size, self.squared_error))

    def squared_error(self, level: int) -> Floats:
        """The squared standard error of the mean if blocks of 2**level samples were independent."""
        count = self._counts[level]
        result: Floats = self._squares[level] / (count * (count - 1))
        return result

    def errors(self, size: int, squared_error: Callable[[int], Floats]) -> tuple[Floats, Floats]:
        """Standard errors and numbers of independent samples of `size` averages, whose squared errors are given as by `squared_error`."""
        levels = [level for level, count in enumerate(self._counts) if count >= _LEAST_BLOCKS]
        by_level = np.array([squared_error(level) for level in levels] or [np.full(size, np.nan)])
        squared, ratio = np.full((2, size), np.nan)
        # If all samples are equal, the errors are 0 for each length of blocks, as for independent samples.
        growth = np.divide(by_level, by_level[0], out=np.ones_like(by_level), where=by_level[0] != 0)
        for level in reversed(levels):
            chosen = 8.0**level > 2 * len(self) * growth[level] ** 2
            squared, ratio = np.where(chosen, by_level[level], squared), np.where(chosen, growth[level], ratio)
        with np.errstate(divide="ignore"):
            return np.sqrt(squared), len(self) / ratio

    def state(self) -> Floats:
        """All numbers, for `restore`: a row for each length of blocks."""
        rows = [np.concatenate([[count], *parts]) for count, *parts in zip(self._counts, self._means, self._squares, self._pending)]
        return np.array(rows).reshape(len(rows), 1 + 3 * self.size)

    @classmethod
    def restore(cls, state: ArrayLike) -> Blocking:
        """Averages that continue those whose `state` is given, bit by bit.

        Parameters
        ----------
        state : array_like

        Returns
        -------
        Blocking
        """
        made = cls((np.shape(state)[-1] - 1) // 3 if np.ndim(state) == 2 else 1)
        made._take(state)
        return made

    def _take(self, state: ArrayLike) -> None:
        """Continues what has a state of this size."""
        rows = np.array(state, dtype=np.float64)
        counts = rows[:, 0] if rows.ndim == 2 and rows.shape[1] == 1 + 3 * self.size else np.array([np.nan])
        first = counts[0] if len(counts) else 0
        if not (len(counts) < 64 and all(count >= 1 and count == first // 2**k for k, count in enumerate(counts))):
            raise ValueError(f"Blocking.restore: this is no state() of samples of {self.size} numbers")
        self._counts = [int(count) for count in counts]
        for k, parts in enumerate((self._means, self._squares, self._pending)):
            parts[:] = rows[:, 1 + k * self.size : 1 + (k + 1) * self.size].copy()
