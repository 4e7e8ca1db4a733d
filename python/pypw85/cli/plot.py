# SPDX-License-Identifier: BSD-3-Clause
"""``pw85 plot``: distributions over the frames of a file."""

from __future__ import annotations

from typing import Any

import click
import numpy as np

from .._drawing import check_picture
from .._statistics import Correlation, correlation, nematic_order
from ..formats import FileError, replacing
from ._input import Input, check_outputs, input_options
from ._progress import progress, say


@click.command()
@input_options
@click.argument("picture")
@click.option("--reach", type=click.FloatRange(0, min_open=True), default=2.0, show_default=True, help="Largest μ.")
@click.option("--bins", type=click.IntRange(1), default=100, show_default=True, help="How many bins.")
def plot(given: Input, picture: str, reach: float, bins: int) -> int:
    """Plot, over the chosen frames of FILE, how many pairs have which μ, their pair correlation in μ, and the nematic order
    of each frame, which is printed, too."""
    check_picture(picture)
    check_outputs(given, picture)
    found: list[Correlation] = []
    orders = []
    with progress() as stage:
        say(f"{'frame':>6} {'step':>10} {'nematic order':>14}")
        for frame, system in given.numbered_systems():
            stage(f"frame {frame}")
            if not len(system):
                say(f"{frame:>6} {system.step:>10} {'no particles':>14}")
                continue
            found.append(correlation(system, reach, bins))
            orders.append((frame, nematic_order(system)))
            say(f"{frame:>6} {system.step:>10} {orders[-1][1]:>14.4f}")
        if not orders:
            raise FileError(given.path, "there are no such frames with particles: choose others (--frames)")
        figure = _figure(found, orders)
        with replacing(picture) as temporary:
            figure.savefig(temporary)
    return 0


def _figure(found: list[Correlation], orders: list[tuple[int, float]]) -> Any:
    import matplotlib.figure

    edges = found[0].edges
    pairs, uncorrelated = (np.sum([getattr(one, name) for one in found], axis=0) for name in ("pairs", "uncorrelated"))
    figure = matplotlib.figure.Figure(figsize=(12, 3.6), constrained_layout=True)
    distribution, correlated, order = figure.subplots(1, 3)
    distribution.stairs(pairs / len(found), edges, fill=True)
    distribution.set(xlabel="μ", ylabel="pairs in a frame", xlim=(0, edges[-1]))
    correlated.stairs(pairs / uncorrelated, edges)
    correlated.axhline(1, color="grey", linewidth=0.6)
    correlated.set(xlabel="μ", ylabel="g(μ)", xlim=(0, edges[-1]), ylim=(0, None))
    order.plot(*np.transpose(orders), marker="o", markersize=3)
    order.set(xlabel="frame", ylabel="nematic order", ylim=(-0.05, 1.05))
    return figure
