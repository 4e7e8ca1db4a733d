# SPDX-License-Identifier: BSD-3-Clause
"""Time series that `pw85 mc` wrote: in the file of a run, or in its table."""

from __future__ import annotations

from typing import Any

import numpy as np

from .._typing import Floats
from ..formats import FileError, hdf5
from ..formats._errors import guarded

# The columns that are plotted, by what they are called on the axes
_PLOTTED = {
    "nematic_order": "nematic order S",
    "compressibility_chains": "Z (chains)",
    "compressibility_contacts": "Z (contacts)",
    "density": "density",
    "energy": "energy",
}
_HEADER = "sweep,volume,density,"


def is_table(path: str) -> bool:
    """Returns whether a file begins like the table of a run."""
    return _start(path) == _HEADER.encode()


def read_series(path: str) -> dict[str, Floats] | None:
    """The columns of the samples of a run by their names; None if the file is not a run of `pw85 mc`."""
    if is_table(path):
        return _from_table(path)
    if not _start(path).startswith(b"\x89HDF"):
        return None
    try:
        return _from_run(path)
    except FileError as error:
        raise FileError(path, error.reason.replace("write it again", "bring back a copy of it")) from None


def _start(path: str) -> bytes:
    with open(path, "rb") as file:
        return file.read(len(_HEADER))


def _from_table(path: str) -> dict[str, Floats]:
    with open(path, encoding="utf-8") as file:
        names = file.readline().strip().split(",")
        try:
            rows = np.loadtxt(file, delimiter=",", ndmin=2, dtype=np.float64)
        except ValueError:
            raise FileError(path, "is not a complete table of a run of pw85 mc: restore a copy of it") from None
    if not rows.size:
        raise FileError(path, "has no samples yet")
    if rows.shape[1] != len(names):
        raise FileError(path, f"has {rows.shape[1]} numbers in a line, but {len(names)} names: bring back a copy of it")
    return dict(zip(names, rows.T, strict=True))


@guarded
def _from_run(path: str) -> dict[str, Floats] | None:
    with hdf5.opened(path) as file:
        if "pw85_mc" not in file:
            return None
        group = file["pw85_mc"]
        if "samples" not in group or not len(group["samples"]):
            raise FileError(path, "has no samples yet: they are in it when the run has ended or was interrupted")
        samples = group["samples"][()]
    return {name: np.asarray(samples[name], dtype=np.float64) for name in samples.dtype.names}


def series_figure(series: dict[str, Floats]) -> Any:
    """Each number that is known and changes against the sweeps, with its running mean."""
    import matplotlib.figure

    chosen = {name: label for name, label in _PLOTTED.items() if _has_values(series.get(name))}
    figure = matplotlib.figure.Figure(figsize=(8, 2.2 * max(len(chosen), 1)), constrained_layout=True)
    axes = figure.subplots(max(len(chosen), 1), 1, sharex=True, squeeze=False)[:, 0]
    for ax, (name, label) in zip(axes, chosen.items()):
        values = series[name]
        ax.plot(series["sweep"], values, color="0.75", linewidth=0.8, label="samples")
        ax.plot(series["sweep"], running_mean(values), color="tab:blue", label="mean up to here")
        ax.set(ylabel=label, ylim=_limits(values))
        ax.ticklabel_format(axis="y", useOffset=False)
    axes[0].legend(loc="best", fontsize="small")
    axes[-1].set(xlabel="sweeps")
    return figure


def _has_values(values: Floats | None) -> bool:
    """Numbers that stay exactly as they are, such as the density at constant volume, are shown as a line unless they are 0 or unknown."""
    return values is not None and bool(np.isfinite(values).all()) and bool(values.any())


# Densities are quotients of numbers that are the same up to some units of rounding.
_ROUNDING = 1e-12


def _limits(values: Floats) -> tuple[float, float] | None:
    """The limits of the axis of a number that is constant up to rounding errors, 5 % to either side; None for others."""
    least, most = float(values.min()), float(values.max())
    if most - least > _ROUNDING * max(abs(least), abs(most)):
        return None
    margin = 0.05 * abs(most)
    return most - margin, most + margin


def running_mean(values: Floats) -> Floats:
    """The mean of the first 1, 2, … values."""
    means: Floats = np.cumsum(values) / np.arange(1, len(values) + 1)
    return means
