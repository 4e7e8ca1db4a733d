"""``pw85 pack``: random packings; ``pw85 relax``: a file without its overlaps."""

from __future__ import annotations

from typing import Any

import click
import numpy as np

from .._packing import pack as pack_system
from .._packing import relax as relax_system
from .._voxels import save_voxels
from ..formats import FORMATS, guess_for_writing, write
from ._input import Input, Numbers, input_options
from ._progress import progress

_steps = click.option("--steps", type=click.IntRange(1), default=5000, show_default=True, help="How many steps to try.")
_to = click.option("--to", type=click.Choice(list(FORMATS)), help="Format of OUTPUT; by the end of its name if absent.")


@click.command()
@click.argument("output")
@click.option("-n", "--number", type=click.IntRange(1), required=True, help="How many ellipsoids.")
@click.option("--axes", "kinds", type=Numbers(3), multiple=True, required=True,
              help="Semi-axes; if given several times, there are as many of each kind.")
@click.option("--spread", type=click.FloatRange(0), default=0.0, show_default=True,
              help="Standard deviation of the logarithm of sizes.")
@click.option("--fraction", type=click.FloatRange(0, 1, min_open=True, max_open=True), required=True, help="Packing fraction.")
@click.option("--cell", type=Numbers(3, 9), help="Shape of the cell (scaled to the fraction): a cube if absent.")
@click.option("--seed", type=click.IntRange(0), default=0, show_default=True, help="Another one, another packing.")
@click.option("--voxels", metavar="FILE", help="Write a voxel image, too (.vtk or .h5): 0, or the number of the ellipsoid.")
@click.option("--resolution", type=click.IntRange(1), default=64, show_default=True, help="Voxels along each vector of the cell.")
@_to
@_steps
def pack(output: str, number: int, kinds: Any, spread: float, fraction: float, cell: Any, seed: int, voxels: str | None,
         resolution: int, to: str | None, steps: int) -> int:  # fmt: skip
    """Write a random periodic packing of ellipsoids without overlaps to OUTPUT."""
    to = to or guess_for_writing(output)
    types = np.arange(number) % len(kinds)
    sizes = np.exp(spread * np.random.default_rng(seed).normal(size=(number, 1)))
    if cell is not None:
        cell = np.diag(cell) if len(cell) == 3 else cell.reshape(3, 3)
    with progress() as stage:
        system = pack_system(np.array(kinds)[types] * sizes, fraction, cell, seed + 1, types + 1, steps, stage)
        stage("writing")
        write(output, system, to)
        if voxels is not None:
            save_voxels(voxels, system, resolution)
    return 0


@click.command()
@input_options
@click.argument("output")
@_to
@_steps
def relax(given: Input, output: str, to: str | None, steps: int) -> int:
    """Move and turn the ellipsoids of the chosen frames of FILE until none overlap, and write them to OUTPUT."""
    with progress() as stage:
        systems = (relax_system(system, steps, stage) for system in given.systems())
        write(output, systems, to or guess_for_writing(output))
    return 0
