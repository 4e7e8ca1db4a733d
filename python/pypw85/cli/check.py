# SPDX-License-Identifier: BSD-3-Clause
"""``pw85 check``: finds overlaps, and the pairs with the smallest μ."""

from __future__ import annotations

import contextlib
import itertools
import multiprocessing
import os
import signal
import sys
from typing import Any, TextIO
from collections.abc import Callable, Iterator

import click
import numpy as np

from .._statistics import director, nematic_order, tetratic_order
from .._system import System
from .._words import counted
from ..formats import STANDARD_OUTPUT, FileError, Location
from ._input import Finite, Input, WholeNumber, check_outputs, command, input_options, refuse_idle
from ._interruption import shield_processes
from ._progress import progress, say
from ._reports import Found, csv_report, hdf5_report, json_report


@command(short_help="Find the ellipsoids of a file that overlap.")
@input_options
@click.option("--worst", type=WholeNumber(0), default=10, show_default=True, metavar="N",
              help="Number of pairs to print: those with the smallest μ. μ is the factor by which both ellipsoids must be scaled to touch.")
@click.option("--below", type=Finite(), default="1.0", show_default=True,
              metavar="μ",
              help="Pairs to write to the files of --csv, --json and --hdf5: all with μ below this number. 1 means those that overlap.")
@click.option("--csv", "csv_path", metavar="FILE", help="Write these pairs as a table; - means the standard output.")
@click.option("--json", "json_path", metavar="FILE", help="Write these pairs, and what is printed, as JSON; - means the standard output.")
@click.option("--hdf5", "hdf5_path", metavar="FILE", help="Write these pairs, and what is printed, as HDF5.")
@click.option("--workers", type=WholeNumber(), default=1, show_default=True, metavar="N",
              help="Number of processes that share the frames. More than one needs the Python package dask.")
@click.option("--varying", is_flag=True, help="Allow that the number of particles changes from frame to frame.")
def check(given: Input, worst: int, below: float, csv_path: str | None, json_path: str | None,
          hdf5_path: str | None, workers: int, varying: bool) -> int:  # fmt: skip
    """Find the ellipsoids of FILE that overlap. The exit status is 0 if none overlap, 1 if some overlap, and 2 if the input is invalid."""
    refuse_idle({"below": ("csv_path", "json_path", "hdf5_path")})
    outputs = [(csv_report, csv_path), (json_report, json_path), (hdf5_report, hdf5_path)]
    check_outputs(given, csv_path, json_path, hdf5_path)
    summary = _Summary(given, worst, sys.stderr if STANDARD_OUTPUT in (csv_path, json_path, hdf5_path) else None)
    with contextlib.ExitStack() as stack:
        adds = [stack.enter_context(kind(path)) for kind, path in outputs if path is not None]
        stage = stack.enter_context(progress())
        for found in _reported(_survey_all(given, worst, below, workers, stage), summary):
            summary.add(found, varying)
            for add in adds:
                add(found)
    summary.end()
    return summary.status(given.has_points)


def _reported(surveys: Iterator[Found], summary: _Summary) -> Iterator[Found]:
    """If a frame cannot be read, prints the report on the frames before it first."""
    try:
        yield from surveys
    except FileError:
        summary.end()
        raise


def survey(given: Input, location: Location, worst: int, below: float, stage: Callable[[str], object] = str) -> Found:
    """Checks a frame. Calls `stage` with a description of each step."""
    stage(f"frame {location.frame}: reading")
    system = given.load(location)
    stage(f"frame {location.frame}: checking")
    try:
        report = system.check(worst, below)
    except MemoryError:
        if below <= 1:
            raise
        raise ValueError(f"not enough memory for all pairs with μ < {below:g}: use a smaller number (--below)") from None
    return Found(location.frame, system.step, system.cell, system.periodic, report,
                 system.ids[report.contacts.pairs], system.ids[report.worst.pairs],
                 _measures(system), system.source, system.notes)  # fmt: skip


def _measures(system: System) -> dict[str, Any]:
    """Density and order parameters; None if they are undefined."""
    orders: dict[str, Any] = {"nematic_order": nematic_order, "director": director}
    if system.dimensions == 2:
        orders["tetratic_order"] = tetratic_order
    found: dict[str, Any] = {name: np.asarray(order(system) if len(system) else np.nan) for name, order in orders.items()}
    return {"density": system.density} | {name: None if np.isnan(one).any() else one.tolist() for name, one in found.items()}


def _survey_all(
    given: Input, worst: int, below: float, workers: int, stage: Callable[[str], object]
) -> Iterator[Found]:
    if workers == 1:
        for location in given.locations():
            yield survey(given, location, worst, below, stage)
    else:
        yield from _survey_with_dask(given, worst, below, workers, stage)


def _survey_with_dask(
    given: Input, worst: int, below: float, workers: int, stage: Callable[[str], object]
) -> Iterator[Found]:
    """Checks a few frames at a time, so that only their reports are in memory."""
    from concurrent.futures import ProcessPoolExecutor

    from dask.base import compute
    from dask.delayed import delayed

    os.environ.setdefault("OMP_NUM_THREADS", "1")
    shield_processes()
    locations = _until_error(given.locations())
    context = multiprocessing.get_context("spawn")  # a fork would inherit OpenMP's threads, which are gone in it
    with ProcessPoolExecutor(workers, context, signal.signal, (signal.SIGINT, signal.SIG_IGN)) as pool:
        while batch := list(itertools.islice(locations, 4 * workers)):
            tasks = [delayed(_survey_or_error)(given, location, worst, below) for location in batch]
            numbers = [one.frame or 0 for one in batch]
            stage(f"frames {numbers[0]} to {numbers[-1]}")
            for found in compute(*tasks, scheduler="processes", pool=pool):
                if isinstance(found, Exception):
                    raise found
                yield found


def _until_error(locations: Iterator[Location]) -> Iterator[Location | FileError]:
    """Yields frames, and at the end the error, if the next frame cannot be found."""
    try:
        yield from locations
    except FileError as error:
        yield error


def _survey_or_error(given: Input, location: Location | FileError, worst: int, below: float) -> Found | Exception:
    """Returns errors as results, since dask would put the traceback of the worker into their text."""
    if isinstance(location, FileError):
        return location
    try:
        return survey(given, location, worst, below)
    except (OSError, ValueError, MemoryError) as error:
        return error


class _Summary:
    """Prints a line for each frame, and the worst pairs of all frames."""

    def __init__(self, given: Input, worst: int, stream: TextIO | None = None) -> None:
        """`stream` is the standard output if absent."""
        self.given, self.count, self.stream = given, worst, stream
        self.frames = self.overlaps = self.particles = self.shapeless = 0
        self.source = ""
        self.worst: list[tuple[Any, ...]] = []
        self.warned: set[str] = set()

    def add(self, found: Found, varying: bool) -> None:
        report = found.report
        total = report.particles + report.shapeless
        if self.frames == 0:
            self._header(found)
        elif found.source != self.source and total:
            self._say(f"frame {found.frame}: {found.source}")
        self.source = found.source if total or not self.frames else self.source
        if total and self.particles and total != self.particles and not varying:
            raise FileError(self.given.path, f"there are {total} particles, but {self.particles} in the first frame: "
                            "allow it (--varying), or choose frames (--frames)", found.frame)  # fmt: skip
        self.particles = self.particles or total
        self.frames += 1
        self.overlaps += report.overlaps
        self.shapeless = max(self.shapeless, report.shapeless)
        self._say(_LINE.format(found.frame, found.step, report.particles, _number(report.packing_fraction),
                                report.pairs_tested, report.overlaps, _number(report.smallest_mu)))  # fmt: skip
        self._warn(found)
        rows = zip(map(float, report.worst.mu), itertools.repeat(found.frame), found.worst_ids, *report.worst[1:2], *report.worst[4:])
        self.worst = sorted([*self.worst, *rows], key=lambda row: row[:2])[: self.count]

    def status(self, points: bool) -> int:
        """Returns the exit status: 0 if all particles of all frames were checked, and none overlap."""
        if not self.particles:
            raise FileError(self.given.path, "there are no particles: choose other frames with --frames, or write the file again")
        if self.shapeless and not self.overlaps and not points:
            raise FileError(self.given.path, counted(self.shapeless, "particle without a shape was", "particles without a shape were") +
                            " not checked: give a shape (--shape), or say that these are points (--points)")  # fmt: skip
        return int(self.overlaps > 0)

    def _say(self, line: str) -> None:
        say(line, self.stream)

    def _header(self, found: Found) -> None:
        self._say(self.given.describe(found.source))
        if found.cell is None:
            self._say("no cell")
        else:
            flags = "".join(name for name, flag in zip("abc", found.periodic) if flag) or "none"
            dimensions = found.report.dimensions
            self._say(f"cell {' | '.join(_vector(row[:dimensions]) for row in found.cell[:dimensions])}, periodic along {flags}")
        fraction = "area fraction" if found.report.dimensions == 2 else "packing fraction"
        self._say(_LINE.format("frame", "step", "particles", fraction, "pairs tested", "overlaps", "smallest μ"))

    def _warn(self, found: Found) -> None:
        report, limit = found.report, found.report.nearest_image_limit
        for note in found.notes:
            self._once(note, note, found.frame)
        if not report.particles + report.shapeless:
            self._once("empty", "there are no particles", found.frame)
        if report.shapeless:
            left = counted(report.shapeless, "particle without a shape is", "particles without a shape are")
            self._once("shapes", f"{left} left out", found.frame)
        if limit is not None and limit < 1:
            self._once("cell", "the cell is so small that programs which look at nearest images only miss overlaps "
                       "(this one looks at all images)", found.frame)  # fmt: skip

    def _once(self, kind: str, sentence: str, frame: int) -> None:
        if kind not in self.warned:
            self.warned.add(kind)
            say(f"pw85: warning: {self.given.path}, frame {frame}: {sentence}", sys.stderr)

    def end(self) -> None:
        if not self.worst:
            return
        self._say("\nworst pairs")
        self._say(_PAIR.format("frame", "id", "id", "image", "μ", "contact point", "normal"))
        for mu, frame, ids, image, point, normal in self.worst:
            image = " ".join(map(str, image))
            self._say(_PAIR.format(frame, *ids.tolist(), image, f"{mu:.6g}", _vector(point), _vector(normal)))


_LINE = "{:>5} {:>9} {:>9} {:>16} {:>12} {:>8} {:>10}"
_PAIR = "{:>5} {:>7} {:>7} {:>7} {:>10}  {:<21} {}"


def _number(value: float | None) -> str:
    return "-" if value is None else f"{value:.6g}"


def _vector(row: Any) -> str:
    return " ".join(f"{value:.4g}" for value in np.asarray(row) + 0.0)
