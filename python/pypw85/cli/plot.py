# SPDX-License-Identifier: BSD-3-Clause
"""``pw85 plot``: distributions over the frames of a file."""

from __future__ import annotations

import contextlib
import sys
import warnings
from functools import partial
from typing import Any
from collections.abc import Iterator

import click
import numpy as np

from .._drawing import check_picture
from .._observables import MOST_BINS
from .._statistics import Correlation, correlation, nematic_order, pair_correlation, tetratic_order
from .._system import System
from .._typing import Floats
from .._words import counted
from ..formats import FileError, refuse_standard_output, replacing
from ._input import Finite, Input, WholeNumber, check_outputs, command, input_options
from ._progress import progress, say
from ._series import is_table, read_series, series_figure


@command(short_help="Plot the distribution of μ and the nematic order of a trajectory, or the averages of a run.")
@partial(input_options, is_other=is_table)
@click.argument("picture")
@click.option("--reach", type=Finite(), default="2.0", show_default=True, metavar="μ",
              help="Largest μ of the histogram and of the pair correlation.")
@click.option("--bins", type=WholeNumber(most=MOST_BINS), default=100, show_default=True, metavar="N",
              help="Number of bins of the histogram and of the pair correlations.")
def plot(given: Input, picture: str, reach: float, bins: int) -> int:
    """Plot distributions over the chosen frames of FILE: the histogram of μ (pairs per frame), the pair correlation g(μ), and the nematic
    order of each frame. The command also prints the nematic orders. The extension of PICTURE selects its format, such as .png or .pdf.

    μ is the factor by which both ellipsoids of a pair must be scaled to touch. g(μ) is the number of pairs divided by the number that is
    expected without correlations. The cell of FILE must be known. For ellipses in a plane there are two more plots: g(r), the pair
    correlation as a function of the distance, with the mean of cos 2Δθ, where Δθ is the angle between the ellipses of a pair; and the
    tetratic order of each frame.

    If FILE is the file of a run of pw85 mc (.h5), or its table (.csv), the command instead plots the samples of the run against the sweeps,
    with running means: nematic order, compressibility Z = βP/ρ, density, and energy if there is one. For the distributions, plot a
    trajectory of the run."""
    refuse_standard_output(picture, "the end of a name says the format of a picture")
    check_picture(picture, allows_page=False)
    check_outputs(given, picture)
    series = read_series(given.path)
    if series is not None:
        _refuse_distributions()
        _plot_series(series, picture)
        return 0
    found: list[Correlation] = []
    orders: list[tuple[float, ...]] = []
    rings = _Rings(bins)
    with progress() as stage:
        for frame, system in given.numbered_systems(sys.stdout):
            stage(f"frame {frame}")
            names = ["nematic order", "tetratic order"][: 4 - system.dimensions]
            if not found:
                say(f"{'frame':>6} {'step':>10} {' '.join(f'{name:>14}' for name in names)}")
            if not len(system):
                say(f"{frame:>6} {system.step:>10} {'no particles':>14}")
                continue
            with _explaining_memory(reach):
                found.append(correlation(system, reach, bins))
                rings.add(system, reach)
            row = [order(system) for order in (nematic_order, tetratic_order)[: len(names)]]
            if orders and len(orders[0]) != 1 + len(row):
                raise FileError(given.path, "frames have different dimensions: choose frames, or say which (--dimensions)", frame)
            orders.append((frame, *row))
            say(f"{frame:>6} {system.step:>10} {' '.join(f'{value:>14.4f}' for value in row)}")
        if not orders:
            raise FileError(given.path, "the chosen frames have no particles: choose others with --frames")
        if not any(one.pairs.any() for one in found):
            warnings.warn(f"{given.path}: no pair has μ < {reach:g}, so there is nothing in the plots of μ: use a larger number (--reach)",
                          stacklevel=1)  # fmt: skip
        figure = _figure(found, orders, rings)
        with replacing(picture) as temporary:
            figure.savefig(temporary)
    return 0


@contextlib.contextmanager
def _explaining_memory(reach: float) -> Iterator[None]:
    try:
        yield
    except MemoryError:
        raise ValueError(f"not enough memory for all pairs with μ < {reach:g}: use a smaller number (--reach)") from None


def _refuse_distributions() -> None:
    """Refuses options that have no effect on time series."""
    ctx = click.get_current_context()
    for param in ctx.command.params:
        is_given = ctx.get_parameter_source(param.name or "") is click.core.ParameterSource.COMMANDLINE
        if is_given and isinstance(param, click.Option) and param.name != "format":
            raise click.UsageError(f"{param.opts[0]} has no effect on the time series of a run: leave it out, or name a trajectory")


def _plot_series(series: dict[str, Floats], picture: str) -> None:
    figure = series_figure(series)
    with replacing(picture) as temporary:
        figure.savefig(temporary)
    say(f"{picture}: {counted(len(series['sweep']), 'sample')} up to sweep {series['sweep'][-1]:.0f}")


class _Rings:
    """Sums of the pair correlations by distance of ellipses, up to `reach` times their longest diameter."""

    def __init__(self, bins: int) -> None:
        self.bins, self.frames = bins, 0
        self.edges: Floats = np.zeros(0)
        self.g: Floats = np.zeros(0)
        self.cosines: Floats = np.zeros(0)

    def add(self, system: System, reach: float) -> None:
        if system.dimensions != 2 or not all(system.periodic[:2]):
            return
        if not self.frames:
            self.edges = np.linspace(0, reach * 2 * system.semi_axes[:, :2].max(), self.bins + 1, dtype=np.float64)
            self.g = self.cosines = np.zeros(self.bins)
        one = pair_correlation(system, float(self.edges[-1]), self.bins)
        self.frames, self.g = self.frames + 1, self.g + one.g
        self.cosines = self.cosines + np.nan_to_num(one.p2) * one.g

    def draw(self, ax: Any) -> None:
        ax.stairs(self.g / self.frames, self.edges, label="g(r)")
        with np.errstate(invalid="ignore"):
            ax.stairs(self.cosines / self.g, self.edges, label="⟨cos 2Δθ⟩(r)")
        ax.axhline(1, color="grey", linewidth=0.6)
        ax.set(xlabel="r", xlim=(0, self.edges[-1]))
        ax.legend()


def _figure(found: list[Correlation], orders: list[tuple[float, ...]], rings: _Rings) -> Any:
    import matplotlib.figure

    edges = found[0].edges
    pairs, uncorrelated = (np.sum([getattr(one, name) for one in found], axis=0) for name in ("pairs", "uncorrelated"))
    columns = 4 if rings.frames else 3
    figure = matplotlib.figure.Figure(figsize=(4 * columns, 3.6), constrained_layout=True)
    distribution, correlated, *by_distance, order = figure.subplots(1, columns)
    distribution.stairs(pairs / len(found), edges, fill=True)
    # The axis begins where pairs are.
    some = np.flatnonzero(pairs)
    first = float(edges[some[0]]) if len(some) else 0.0
    distribution.set(xlabel="μ", ylabel="pairs in a frame", xlim=(first, edges[-1]))
    correlated.stairs(pairs / uncorrelated, edges)
    correlated.axhline(1, color="grey", linewidth=0.6)
    correlated.set(xlabel="μ", ylabel="g(μ)", xlim=(first, edges[-1]), ylim=(0, None))
    for ax in by_distance:
        rings.draw(ax)
    frames, *several = np.transpose(orders)
    for name, row in zip(("nematic order", "tetratic order"), several):
        order.plot(frames, row, marker="o", markersize=3, label=name)
    order.set(xlabel="frame", ylabel="nematic order" if len(several) == 1 else "order", ylim=(-0.05, 1.05))
    if len(several) > 1:
        order.legend()
    return figure
