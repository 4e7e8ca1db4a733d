# SPDX-License-Identifier: BSD-3-Clause
"""``pw85 pack``: random packings; ``pw85 relax``: a file without its overlaps."""

from __future__ import annotations

import sys
from functools import partial
from typing import Any
from collections.abc import Callable, Iterator

import click
import numpy as np

from .._packing import OverlapsLeft, RelaxationInterrupted
from .._packing import pack as pack_system
from .._packing import relax as relax_system
from .._system import System
from .._voxels import check_voxels_name, save_voxels
from ..formats import WRITABLE, check_written_name, write
from ._input import Finite, Input, Numbers, WholeNumber, input_options
from ._interruption import is_interrupted, keeping_work
from ._progress import progress, say

_steps = click.option("--steps", type=WholeNumber(), default=20000, show_default=True, help="How many steps to try.")
_to = click.option("--to", type=click.Choice(WRITABLE), help="Format of OUTPUT; by the end of its name if absent.")


@click.command()
@click.argument("output")
@click.option("-n", "--number", type=WholeNumber(), required=True, help="How many ellipsoids.")
@click.option("--axes", "kinds", type=Numbers(3, positive=True), multiple=True, required=True, metavar="A,B,C",
              help="Semi-axes; if given several times, there are as many of each kind.")
@click.option("--spread", type=Finite(may_be_zero=True), default="0", show_default=True,
              help="Standard deviation of the natural logarithm of sizes.")
@click.option("--fraction", type=click.FloatRange(0, 1, min_open=True, max_open=True), required=True, help="Packing fraction.")
@click.option("--cell", type=Numbers(3, 9), metavar="NUMBER,...",
              help="Shape of the cell, A,B,C or three vectors, which is scaled to the fraction: a cube if absent.")
@click.option("--seed", type=WholeNumber(0), default=0, show_default=True, help="Another one, another packing.")
@click.option("--voxels", metavar="FILE", help="Write a voxel image, too (.vtk or .h5): 0, or the number of the ellipsoid.")
@click.option("--resolution", type=WholeNumber(), default=64, show_default=True, help="Voxels along each vector of the cell.")
@_to
@_steps
def pack(output: str, number: int, kinds: Any, spread: float, fraction: float, cell: Any, seed: int, voxels: str | None,
         resolution: int, to: str | None, steps: int) -> int:  # fmt: skip
    """Write a random periodic packing of ellipsoids without overlaps to OUTPUT.

    If some are left after all steps, or at Ctrl-C, OUTPUT is the best that was found, and the status is 1 or 130.
    """
    to = check_written_name(output, to)
    if voxels is not None:
        check_voxels_name(voxels)
    types = np.arange(number) % len(kinds)
    sizes = np.exp(spread * np.random.default_rng(seed).normal(size=(number, 1)))
    if cell is not None:
        cell = np.diag(cell) if len(cell) == 3 else cell.reshape(3, 3)
    best, packed = _Best(output), []

    def packings() -> Iterator[System]:  # begins when the file can be written
        axes = np.array(kinds)[types] * sizes
        packed.append(best.of(partial(pack_system, axes, fraction, cell, seed + 1, types + 1, steps, stage)))
        yield from packed

    with keeping_work(), progress() as stage:
        write(output, packings(), to)
        if voxels is not None:
            save_voxels(voxels, packed[0], resolution)
    return best.report()


@click.command()
@input_options
@click.argument("output")
@_to
@_steps
def relax(given: Input, output: str, to: str | None, steps: int) -> int:
    """Move and turn the ellipsoids of the chosen frames of FILE until none overlap, and write them to OUTPUT.

    If some are left after all steps, or at Ctrl-C, OUTPUT has the best that was found, and the status is 1 or 130. After Ctrl-C
    all further frames are written as they are.
    """
    to = check_written_name(output, to)
    best = _Best(output)

    def relaxed() -> Iterator[System]:
        for frame, system in given.numbered_systems():
            done = is_interrupted() or not len(system)
            yield system if done else best.of(partial(relax_system, system, steps, stage), frame)

    with keeping_work(), progress() as stage:
        write(output, relaxed(), to)
    return best.report()


class _Best:
    """The best results of relaxations for a file, and sentences about overlaps that are left."""

    def __init__(self, output: str) -> None:
        self.output, self.status = output, 0
        self.sentences: list[str] = []

    def of(self, attempt: Callable[[], System], frame: int | None = None) -> System:
        where = self.output if frame is None else f"{self.output}, from frame {frame}"
        try:
            return attempt()
        except OverlapsLeft as error:
            best, self.status = error.system, max(self.status, 1)
            self.sentences.append(f"pw85: {where}: {error} (--steps)")
        except RelaxationInterrupted as error:
            best, self.status = error.system, 130
            self.sentences.append(f"pw85: interrupted; {where}: {error}")
        return best

    def report(self) -> int:
        """Prints the sentences, and returns the status of the command."""
        for sentence in self.sentences:
            say(f"{sentence}; the file has the best that was found", sys.stderr)
        return self.status
