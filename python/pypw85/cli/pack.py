# SPDX-License-Identifier: BSD-3-Clause
"""``pw85 pack`` makes random packings; ``pw85 relax`` removes the overlaps of a system."""

from __future__ import annotations

import contextlib
import os
import sys
from functools import partial
from typing import Any, NamedTuple
from collections.abc import Callable, Iterator

import click
import numpy as np

from .._lattices import lattice
from .._packing import OverlapsLeft, RelaxationInterrupted, check_cell, too_thin
from .._packing import pack as pack_system
from .._packing import relax as relax_system
from .._random_addition import AdditionInterrupted, RandomAddition, random_addition
from .._statistics import nematic_order
from .._system import UNIT_BALL, System
from .._voxels import MOST_VOXELS, check_voxels_name, save_voxels
from .._words import counted
from ..formats import WRITABLE, FileError, check_written_name, write
from ._input import Finite, Input, Numbers, WholeNumber, check_outputs, command, input_options, refuse_given, refuse_idle
from ._interruption import is_interrupted, keeping_work
from ._progress import beside, progress, say


class _Axes(Numbers):
    """Three semi-axes, or two of an ellipse."""

    def __init__(self) -> None:
        super().__init__(3, positive=True)

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        count = len(value.replace(",", " ").split())
        return Numbers(2 if count == 2 else 3, positive=True).convert(value, param, ctx)


_steps = click.option("--steps", type=WholeNumber(), default=20000, show_default=True, metavar="N",
                      help="Maximum number of steps in which overlaps are removed.")
_to = click.option("--to", type=click.Choice(WRITABLE), help="Format of OUTPUT. By default the extension of its name decides.")


@click.command(short_help="Write a random packing without overlaps, or a lattice.")
@click.argument("output")
@click.option("-n", "--number", type=WholeNumber(), metavar="N", help="Number of ellipsoids.")
@click.option("--axes", "kinds", type=_Axes(), multiple=True, required=True, metavar="A,B,C",
              help="Semi-axes of the ellipsoids, or A,B for ellipses. Repeat the option for a mixture of shapes, with the same number of "
                   "ellipsoids of each shape (up to one).")
@click.option("--spread", type=Finite(may_be_zero=True), default="0", show_default=True,
              metavar="NUMBER",
              help="Polydispersity: the semi-axes of each ellipsoid are multiplied by one random factor. Its logarithm is normally "
                   "distributed, with this standard deviation.")
@click.option("--fraction", type=Finite(below=1), metavar="NUMBER",
              help="Packing fraction: the volume of all ellipsoids divided by the volume of the cell, > 0 and < 1.")
@click.option("--cell", type=Numbers(2, 3, 4, 9), metavar="NUMBER,...",
              help="Shape of the cell: three edges A,B,C, or nine numbers for three vectors (for ellipses two edges, or four numbers). "
                   "The cell is scaled to obtain the packing fraction. With --rsa and without -n, it is the cell itself. Default: a cube "
                   "(square).")
@click.option("--dimensions", type=click.Choice(["2", "3"]), default="3", show_default=True, help="2 for ellipses in a plane.")
@click.option("--rsa", is_flag=True,
              help="Random sequential addition: insert ellipsoids at random positions, one after the other, until no other one fits.")
@click.option("--attempts", type=WholeNumber(), metavar="N", help="With --rsa: stop after this number of attempts.")
@click.option("--seconds", type=Finite(), metavar="SECONDS", help="With --rsa: stop after this time.")
@click.option("--lattice", "kind", type=click.Choice(["fcc", "sc", "stretched"]),
              help="Write parallel ellipsoids on a lattice instead of a random packing: fcc (face-centred cubic), sc (simple cubic), or "
                   "stretched (an fcc lattice of spheres, stretched such that the spheres become the ellipsoids).")
@click.option("--align", type=Numbers(3), metavar="X,Y,Z",
              help="With --lattice: direction of the long axes of rods, or the short axes of plates. Default: 0,0,1.")
@click.option("--seed", type=WholeNumber(0), default=0, show_default=True,
              help="Seed of the random numbers. Another seed gives another packing.")
@click.option("--voxels", metavar="FILE",
              help="Also write a voxel image to this file (.vtk or .h5). The value of a voxel is the number of the ellipsoid at its "
                   "centre, from 1, or 0.")
@click.option("--resolution", type=WholeNumber(most=MOST_VOXELS), default=64, show_default=True,
              metavar="N",
              help="With --voxels: number of voxels along each cell vector.")
@_to
@_steps
def pack(output: str, number: int | None, kinds: Any, spread: float, fraction: float | None, cell: Any, seed: int, voxels: str | None,
         resolution: int, to: str | None, steps: int, dimensions: str, rsa: bool, attempts: float | None,
         seconds: float | None, kind: str | None, align: Any) -> int:  # fmt: skip
    """Write a random periodic packing of ellipsoids without overlaps to OUTPUT, or one of ellipses with --dimensions 2. The extension of
    OUTPUT selects its format.

    By default -n ellipsoids start at random positions in a cell with the packing fraction --fraction, and a soft repulsion removes the
    overlaps. If overlaps remain after all steps (exit status 1) or after Ctrl-C (exit status 130), OUTPUT contains the best packing that
    was found. With --lattice the ellipsoids are parallel and on a lattice.

    With --rsa there are two modes. With --cell alone, the cell has this size, in the unit of the semi-axes, and is filled until no
    other ellipsoid fits. With -n and --fraction, these determine the size of the cell, --cell determines only its shape, and -n
    ellipsoids are inserted. The command prints the number of ellipsoids and the packing fraction. The exit status is 1 if fewer than -n
    ellipsoids were inserted, or if --attempts or --seconds ended the addition.
    """
    refuse_idle({"attempts": ("rsa",), "seconds": ("rsa",), "align": ("kind",), "resolution": ("voxels",)})
    to = check_written_name(output, to)
    vectors = _check_plane(kinds, cell, int(dimensions), voxels)
    if voxels is not None:
        check_voxels_name(voxels, vectors)
        if os.path.realpath(voxels) == os.path.realpath(output):
            raise click.UsageError("OUTPUT and --voxels must be different files")
    if kind is not None:
        for name in ("rsa", "spread", "cell", "dimensions", "attempts", "seconds", "seed", "steps"):
            refuse_given(name, "with --lattice")
        return _write_lattice(output, to, kinds, number, fraction, kind, align, voxels, resolution)
    if rsa:
        for name in ("spread", "steps"):
            refuse_given(name, "with --rsa, which has as many sizes as there are --axes and makes no steps")
        return _add(output, to, _Wish(np.array(kinds), vectors, number, fraction, seed, attempts, seconds), voxels, resolution)
    if number is None or fraction is None:
        raise click.UsageError("a random packing needs -n and --fraction")
    if number < len(kinds):
        raise click.UsageError(f"-n must be at least {len(kinds)}, the number of shapes (--axes), not {number}")
    wanted: float = fraction
    with _explaining_memory():
        types = np.arange(number) % len(kinds)
        sizes = _sizes(spread, seed, number)
    best, packed = _Best(output), list[System]()

    with _explaining_memory(), keeping_work(), progress() as stage:

        def packings() -> Iterator[System]:  # begins when the file can be written
            axes = np.array(kinds)[types] * sizes
            packed.append(best.of(partial(pack_system, axes, wanted, vectors, seed + 1, types + 1, steps, stage, int(dimensions))))
            yield from packed

        write(output, packings(), to)
        if voxels is not None:
            save_voxels(voxels, packed[0], resolution)
    return best.report(packed[0] if packed else None)


def _sizes(spread: float, seed: int, number: int) -> Any:
    """Factors of the semi-axes of each ellipsoid (number, 1), with a log-normal distribution."""
    with np.errstate(over="ignore"):
        sizes = np.exp(spread * np.random.default_rng(seed).normal(size=(number, 1)))
    if not ((sizes > 0) & (sizes < np.inf)).all():
        raise click.UsageError(f"--spread {spread:g} gives sizes beyond the range of double precision: use a smaller value")
    return sizes


def _write_lattice(output: str, to: str, kinds: Any, number: int | None, fraction: float | None, kind: str, align: Any,
                   voxels: str | None, resolution: int) -> int:  # fmt: skip
    if number is None or fraction is None:
        raise click.UsageError("a lattice needs -n and --fraction")
    if len(kinds) > 1:
        raise click.UsageError("all ellipsoids of a lattice have the same shape: use --axes only once")
    with _as_usage("lattice"):
        system = lattice(kinds[0], fraction, number, kind, (0, 0, 1) if align is None else align)
    write(output, iter([system]), to)
    if voxels is not None:
        save_voxels(voxels, system, resolution)
    say(f"{output}: {_made(system)}", beside(output))
    return 0


@contextlib.contextmanager
def _explaining_memory() -> Iterator[None]:
    """Context manager: explains MemoryError. Ellipsoids that are much longer than the cell have very many near images."""
    try:
        yield
    except MemoryError:
        raise ValueError("not enough memory for the neighbour list: use fewer ellipsoids (-n), a smaller aspect ratio (--axes) or a "
                         "smaller --fraction") from None  # fmt: skip


@contextlib.contextmanager
def _as_usage(name: str) -> Iterator[None]:
    """Context manager: turns errors of a function into usage errors, with options instead of arguments."""
    try:
        yield
    except ValueError as error:
        text = str(error).removeprefix(f"{name}: ").replace('the kind "stretched"', "--lattice stretched")
        argument, _, rest = text.partition(" ")
        raise click.UsageError(f"{_OPTIONS.get(argument, argument)} {rest}") from None


# Options of the command, by the names of the arguments of lattice() and random_addition()
_OPTIONS = {"number": "-n", "fraction": "--fraction", "align": "--align", "semi_axes": "--axes"}


def _made(system: System) -> str:
    """Describes a system without overlaps."""
    dimensions, kind = system.dimensions, "ellipsoid" if system.dimensions == 3 else "ellipse"
    fraction, order = system.packing_fraction, nematic_order(system)
    parts = [f"{counted(len(system), kind)} without overlaps"]
    if fraction is not None and system.cell is not None:
        edges = np.linalg.norm(system.cell[:dimensions], axis=1)
        parts += [f"fraction {fraction:.6g}", f"cell edges {' '.join(f'{edge:.6g}' for edge in edges)}"]
    if not np.isnan(order):
        parts.append(f"nematic order {order:.4f}")
    return ", ".join(parts)


def _check_plane(kinds: Any, cell: Any, dimensions: int, voxels: str | None) -> Any:
    """Checks the numbers of dimensions of the options. Returns the cell vectors, or None."""
    if any(len(one) != dimensions for one in kinds):
        given = "" if dimensions == 2 else ", not 2: add the third one, or --dimensions 2 for ellipses"
        raise click.UsageError(f"--axes must have {dimensions} numbers{given or ' with --dimensions 2, not 3'}")
    if cell is not None and len(cell) not in (dimensions, dimensions**2):
        raise click.UsageError(f"--cell must have {dimensions} or {dimensions**2} numbers with --dimensions {dimensions}")
    if voxels is not None and dimensions == 2:
        raise click.UsageError("--voxels is not supported for ellipses")
    return cell if cell is None else np.diag(cell) if len(cell) == dimensions else cell.reshape(dimensions, dimensions)


class _Wish(NamedTuple):
    """Options of random sequential addition."""

    kinds: Any
    cell: Any | None
    number: int | None
    fraction: float | None
    seed: int
    attempts: float | None
    seconds: float | None

    def vectors(self) -> Any:
        """Returns the cell: as given, or of the size that follows from the number and the packing fraction."""
        if (self.number is None) != (self.fraction is None):
            one, other = ("-n", "--fraction") if self.fraction is None else ("--fraction", "-n")
            raise click.UsageError(f"with --rsa, {one} also needs {other}: add {other}, or use --cell alone")
        if self.cell is None and self.number is None:
            raise click.UsageError("--rsa needs --cell, or -n and --fraction")
        dimensions = self.kinds.shape[1]
        if dimensions == 3 and np.ptp(self.kinds, axis=1).any() and self.number is None and self.attempts is None and self.seconds is None:
            raise click.UsageError("--rsa can prove saturation of ellipses and balls only, not of other ellipsoids: use --attempts, "
                                   "--seconds, or -n with --fraction")  # fmt: skip
        if self.number is None or self.fraction is None:
            return self.cell
        shape, volume = check_cell(np.eye(dimensions) if self.cell is None else self.cell, dimensions)
        mean = UNIT_BALL[dimensions] * self.kinds.prod(axis=1).mean()
        return shape * (self.number * mean / self.fraction / volume) ** (1 / dimensions)


_LIMITS = {
    "saturated": "saturated: no other particle fits at any position and orientation",
    "number": "all inserted",
    "attempts": "not saturated: ended by --attempts",
    "seconds": "not saturated: ended by --seconds",
    "interrupted": "not saturated: interrupted",
}


def _add(output: str, to: str, wish: _Wish, voxels: str | None, resolution: int) -> int:
    """Random sequential addition: writes the result to a file, and prints a summary."""
    vectors = wish.vectors()
    results: list[RandomAddition] = []

    def additions() -> Iterator[System]:
        try:
            results.append(random_addition(wish.kinds, vectors, wish.number, wish.seed, wish.attempts, wish.seconds, stage))
        except AdditionInterrupted as error:
            results.append(error.result)
        yield results[0].system

    with keeping_work(), progress() as stage:
        write(output, additions(), to)
        (result,) = results
        if voxels is not None:
            save_voxels(voxels, result.system, resolution)
    say(f"{counted(len(result.system), 'particle')}, fraction {result.system.packing_fraction:.6f}, {result.attempts:.4g} attempts "
        f"(RSA time {result.time:.4g}), {_LIMITS[result.end]}", beside(output))  # fmt: skip
    if result.end == "interrupted":
        return 130
    return int(result.end in ("attempts", "seconds") or (wish.number or 0) > len(result.system))


@command(short_help="Move and rotate ellipsoids until none overlap.")
@input_options
@click.argument("output")
@_to
@_steps
def relax(given: Input, output: str, to: str | None, steps: int) -> int:
    """Move and rotate the ellipsoids of the chosen frames of FILE until none overlap, and write them to OUTPUT.

    If overlaps remain after all steps (exit status 1) or after Ctrl-C (exit status 130), OUTPUT contains the best configuration that was
    found. After Ctrl-C the remaining frames are written unchanged.
    """
    to = check_written_name(output, to)
    check_outputs(given, output)
    best, counts = _Best(output), list[int]()

    def relaxed() -> Iterator[System]:
        for frame, system in given.numbered_systems(beside(output)):
            done = is_interrupted() or not len(system)
            if not done and (reason := too_thin(system)):
                raise FileError(given.path, f"{reason} (--cell), or skip such frames (--frames)", frame)
            yield system if done else best.of(partial(relax_system, system, steps, stage), frame)
            counts.append(len(system))

    with _explaining_memory(), keeping_work(), progress() as stage:
        write(output, relaxed(), to)
    if not best.status:
        say(f"{output}: {counted(len(counts), 'frame')}, {counted(sum(counts), 'particle')} in all, without overlaps", beside(output))
    return best.report()


class _Best:
    """The best results of relaxations for a file, and messages about overlaps that remain."""

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

    def report(self, made: System | None = None) -> int:
        """Prints the messages, or a description of the system without overlaps. Returns the exit status."""
        if made is not None and not self.status:
            say(f"{self.output}: {_made(made)}", beside(self.output))
        for sentence in self.sentences:
            say(f"{sentence}; the file contains the best configuration that was found", sys.stderr)
        return self.status
