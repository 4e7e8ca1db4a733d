# SPDX-License-Identifier: BSD-3-Clause
"""Runs of `pw85 mc`: what they are asked to do, their state, and the file from which they continue."""

from __future__ import annotations

import contextlib
import errno
import hashlib
import io
import json
import os
import time
import warnings
import zlib
from typing import Any, NamedTuple
from collections.abc import Iterator

import numpy as np

try:
    import fcntl
except ImportError:  # Windows
    fcntl = None  # type: ignore[assignment]

from .._blocking import Estimate
from .._equilibration import Equilibration
from .._core import version
from .._functions import cell_reduce
from .._observables import Observables, Sample
from .._simulations import Change, HardEllipsoids, usual_length
from .._system import System
from ..formats import FORMATS, FileError, gsd, hdf5, read, replacing
from ..formats._errors import guarded
from ..formats._files import checksum

# A sample in a file
_ROW = np.dtype([(name, "f8") for name in ("sweep", *Sample._fields)])
# The acceptance to which steps are tuned: the default of HardEllipsoids.tune().
ACCEPTANCE = 0.4
_GROUP = "pw85_mc"
# The format of the file of a run. A version that writes another one has a higher number, and still reads the lower ones.
_FORMAT = 1
# Part of the sweeps in the first of the windows of an equilibration, whose four windows have at most 15 times as many
_FIRST_WINDOW = 1 / 16
# Free paths of an event chain
PATHS = 50
# Sweeps between two samples, and trials for each event chain; and both in dense systems, where Z is at least DENSE (docs/montecarlo.rst,
# "Samples and their cost"). python/bench/measure_samples.py measures the errors of the pressure by these and by others.
EVERY, TRIALS_PER_CHAIN = 10, 250
EVERY_OF_DENSE, TRIALS_PER_CHAIN_OF_DENSE = 20, 1000
DENSE = 22
# The longest free path over the longest semi-axis: an event chain continues from there as from a contact.
LONGEST_PATH = 1 / 4
# The mean separation along the direction of a chain of two spheres, or discs, that touch, over the sum of their radii: contacts are
# distributed uniformly across the direction.
_MEAN_TRANSFER = {3: 2 / 3, 2: np.pi / 4}
# The shortest vector of the lattice over the longest diameter of the particles, below which cells do not change their shape
_LEAST_WIDTH = 1.25
# What a constant volume holds constant
_OF_VOLUME = {"volume", "density", "packing_fraction"}
_NO_RUN = "is not a run: name a file that pw85 mc has written with --out"
# The first bytes of HDF5
_SIGNATURE = b"\x89HDF\r\n\x1a\n"
_CURE = "bring back a copy of it, or begin a new run"
# The disk, the share of a user, or the size of a file has come to its limit.
_NO_ROOM = {getattr(errno, name) for name in ("ENOSPC", "EDQUOT", "EFBIG") if hasattr(errno, name)}


class Settings(NamedTuple):
    """Settings of a run. Files are named relative to the folder of the run's file."""

    sweeps: int
    equilibrate: int | None  # None: until nothing drifts
    every: int  # 0: as by usual_sampling() after the equilibration
    seed: int
    pressure: float | None
    change: Change
    chains: int | None  # None: as by usual_sampling()
    chain_length: float | None  # None: as by usual_sampling(), or no chains
    trajectory: str | None
    trajectory_format: str
    trajectory_every: int
    has_table: bool
    exchange: float = 0.0
    volume_trials: int = 1
    edges: tuple[float, ...] = ()  # of the cell of the start
    precision: str = "double"  # of a trajectory in GSD
    walls: tuple[str, ...] = ()  # as they were given; the simulation has their numbers
    fields: tuple[str, ...] = ()
    law: str | None = None  # of pairs


class Sampling(NamedTuple):
    """Sweeps between two samples, and the event chains of each sample."""

    every: int
    chains: int
    chain_length: float | None


def usual_sampling(simulation: HardEllipsoids, every: int = 0) -> Sampling:
    """The samples of a bulk system that have small errors for their time, by the Z of one chain through the cell.

    Parameters
    ----------
    simulation : HardEllipsoids
        In equilibrium.
    every : int
        Sweeps between two samples, if they are given; otherwise 0.
    """
    cell: Any = simulation.cell
    compressibility = simulation.chain(1, usual_length(cell, simulation.dimensions))
    excess = max(compressibility - 1, 0.0) if np.isfinite(compressibility) else 0.0  # NaN where own images may touch
    usual = (EVERY_OF_DENSE, TRIALS_PER_CHAIN_OF_DENSE) if excess + 1 >= DENSE else (EVERY, TRIALS_PER_CHAIN)
    every = every or usual[0]
    return Sampling(every, max(1, round(len(simulation) * every / usual[1])), _usual_chain_length(simulation, excess))


def _usual_chain_length(simulation: HardEllipsoids, excess: float) -> float:
    """The length in which an event chain has some fifty free paths, where Z - 1 is `excess`.

    The density of contacts along a chain is (Z - 1)/x, where x is the mean separation along the direction at a contact. That of spheres as
    large as the mean particle is accurate enough for this.
    """
    dimensions = simulation.dimensions
    semi_axes = simulation.semi_axes[:, :dimensions]
    transfer = _MEAN_TRANSFER[dimensions] * 2 * float(np.mean(semi_axes.prod(axis=1)) ** (1 / dimensions))
    return float(PATHS / (excess / transfer + 1 / (LONGEST_PATH * float(semi_axes.max()))))


class _GrowingText:
    """A text file to which frames are added. Its first `length` bytes are kept."""

    def __init__(self, path: str, length: int, format: str) -> None:
        _check_length(path, length, "trajectory")
        self.name, self._save = path, FORMATS[format].save
        self._file = open(path, "a", encoding="utf-8", newline="\n")  # noqa: SIM115 close() closes it
        self._file.truncate(length)

    def add(self, system: System) -> None:
        self._save(self._file, system, system.step)
        self._file.flush()

    def sync(self) -> int:
        """Waits until all frames are on the disk, and says how many bytes they have."""
        os.fsync(self._file.fileno())
        return os.fstat(self._file.fileno()).st_size

    def close(self) -> None:
        self._file.close()


class Run:
    """A run: the simulation, averages, samples, and how far it is.

    `particles` has types and ids, and the origin of the cell, if there is one, in units of its vectors.
    """

    def __init__(self, path: str, settings: Settings, particles: System, simulation: HardEllipsoids, observables: Observables) -> None:
        self.path, self.settings, self.simulation, self.observables = path, settings, simulation, observables
        self.ids, self.corner = particles.ids, particles.origin
        self._type_of = dict(zip(_kinds(simulation), particles.types, strict=True)) if settings.exchange else {}
        self._types = particles.types
        self.equilibrated = self.sweeps = 0
        # Seconds of sweeps, and those of samples with their event chains, since the run began or continued
        self.seconds_of_sweeps = self.seconds_of_samples = 0.0
        first = max(1, int(settings.sweeps * _FIRST_WINDOW))
        self.equilibration = Equilibration(first, observables.width) if settings.equilibrate is None else None
        self.rows: list[tuple[float, ...]] = []  # since the last checkpoint
        # At the last checkpoint: bytes of the trajectory, or its frames in GSD; bytes of the table; samples that are in their file, and the
        # checksum of these.
        self.length = self.table_length = self.saved = self.checksum = 0
        self._finished: Any = None  # samples that are in the file of the run, as long as nothing has been added
        self._trajectory: _GrowingText | gsd.Growing | None = None

    @property
    def is_finished(self) -> bool:
        return self.sweeps >= self.settings.sweeps

    @property
    def is_equilibrated(self) -> bool:
        """Returns whether all sweeps before the first sample were made."""
        if self.equilibration is not None:
            return self.equilibration.is_finished
        return self.equilibrated >= (self.settings.equilibrate or 0)

    @property
    def most_equilibration(self) -> int:
        """The largest number of sweeps of the equilibration."""
        if self.equilibration is None:
            return self.settings.equilibrate or 0
        return self.equilibrated if self.equilibration.is_finished else self.equilibration.most_sweeps

    def _equilibrate(self) -> None:
        """Makes the next sweep before the run, and tunes the steps."""
        settings, simulation = self.settings, self.simulation
        if settings.pressure is not None:  # tune() makes one more, and begins to count again
            simulation.volume_moves(settings.volume_trials - 1, settings.pressure, settings.change)
        simulation.tune(1, ACCEPTANCE, settings.pressure or 0.0, settings.change)
        self.check_cell()
        self.equilibrated += 1
        if self.equilibration is not None:
            self.equilibration.add(simulation)

    def step(self) -> None:
        """Makes the next sweep, and what follows it."""
        settings, simulation = self.settings, self.simulation
        if not self.is_equilibrated:
            self._equilibrate()
            return
        if self.sampling is None:
            settings = self._choose_sampling()
        begin = time.perf_counter()
        simulation.sweep()
        if settings.pressure is not None:
            simulation.volume_moves(settings.volume_trials, settings.pressure, settings.change)
            self.check_cell()
        self.sweeps += 1
        middle = time.perf_counter()
        if self.sweeps % settings.every == 0:
            self._sample()
            self.seconds_of_samples += time.perf_counter() - middle
        self.seconds_of_sweeps += middle - begin
        if self._trajectory is not None and self.sweeps % settings.trajectory_every == 0:
            with self._explaining(self._trajectory.name):
                self._trajectory.add(self.system())

    @property
    def sampling(self) -> Sampling | None:
        """The samples of this run; None until they are chosen."""
        every, chains, length = self.settings.every, self.settings.chains, self.settings.chain_length
        return None if not every or chains is None or (chains and length is None) else Sampling(every, chains, length)

    def _choose_sampling(self) -> Settings:
        """Puts what is usual in the present state where the settings say nothing."""
        begin = time.perf_counter()
        settings = self.settings
        usual = Sampling(EVERY, 0, None) if settings.chains == 0 else usual_sampling(self.simulation, settings.every)
        self.settings = settings = settings._replace(
            every=settings.every or usual.every,
            chains=usual.chains if settings.chains is None else settings.chains,
            chain_length=settings.chain_length or usual.chain_length,
        )
        self.seconds_of_samples += time.perf_counter() - begin
        return settings

    @property
    def constants(self) -> set[str]:
        """The averages that the settings hold constant."""
        settings = self.settings
        return (set() if settings.fields or settings.law else {"energy"}) | (set() if settings.pressure else _OF_VOLUME)

    def unresolved(self) -> list[str]:
        """The names of the averages that have too few independent samples for an error."""
        return [name for name in self.observables.unresolved() if name not in self.constants]

    def averages(self) -> dict[str, Estimate]:
        """The averages. None of them has an error if one number has too few independent samples: the others may follow it. Numbers that
        never change, such as a constant volume, have the error 0."""
        found = {name: one._replace(error=0.0) if name in self.constants else one for name, one in self.observables.estimates().items()}
        if not self.unresolved():
            return found
        return {name: one if one.error == 0 else one._replace(error=np.nan) for name, one in found.items()}

    def check_cell(self) -> None:
        """Refuses a cell that changes its shape, and is so narrow that the images of a particle are next to each other."""
        if self.settings.change == "isotropic":
            return
        cell, dimensions = np.array(self.simulation.cell), self.simulation.dimensions
        if dimensions == 2:  # a vector along z that is longer than those of the plane
            cell[2] = 0, 0, 2 * np.abs(cell[:2]).max()
        shortest = float(np.linalg.norm(cell_reduce(cell), axis=1).min())
        if shortest < _LEAST_WIDTH * 2 * float(self.simulation.semi_axes[:, :dimensions].max()):
            edges = " × ".join(f"{edge:.4g}" for edge in self.edges())
            raise FileError(self.path, f"the cell has the edges {edges}, in which images of particles nearly touch: use --volume isotropic "
                            f"for fluids, or more particles (--volume {self.settings.change} is for crystals)")  # fmt: skip

    def edges(self) -> list[float]:
        """The lengths of the vectors of the cell, in two dimensions of those in the plane."""
        vectors = np.asarray(self.simulation.cell)[: self.simulation.dimensions]
        lengths: list[float] = np.linalg.norm(vectors, axis=1).tolist()
        return lengths

    @property
    def is_stretched(self) -> bool:
        """Returns whether the ratio of two edges of the cell has become at least twice that of the start."""
        change = np.array(self.edges()) / (self.settings.edges or self.edges())
        return bool(change.max() >= 2 * change.min())

    def _sample(self) -> None:
        compressibility = np.nan
        if self.settings.chains:
            compressibility = self.simulation.chain(self.settings.chains, self.settings.chain_length)
        sample = self.observables.add(self.simulation, compressibility)
        self.rows.append((self.sweeps, *sample))
        if self.settings.has_table:
            with self._explaining(self._table_path):
                _add_line(self._table_path, f"{self.sweeps}," + ",".join(f"{value:.17g}" for value in sample))

    @property
    def types(self) -> Any:
        """The types of the start, which go with the semi-axes."""
        return np.array([self._type_of[kind] for kind in _kinds(self.simulation)]) if self._type_of else self._types

    def system(self) -> System:
        """The present state, with the types of the semi-axes and the ids of the start."""
        state = self.simulation.system()
        cell: Any = state.cell
        origin = self.corner if cell is None else self.corner @ cell
        others = {"types": self.types, "ids": self.ids, "origin": origin, "step": self.sweeps}
        others |= {"periodic": state.periodic, "dimensions": state.dimensions}
        return System.from_axes(state.centers, state.semi_axes, state.quaternions, cell=cell, **others)

    # Files

    def open(self) -> None:
        """Opens trajectory, samples and table at their lengths at the last checkpoint."""
        self._open_samples()
        name = self.settings.trajectory
        if name is None:
            return
        path, format = self._beside(name), self.settings.trajectory_format
        with self._explaining(path):
            if format == "gsd":
                self._trajectory = gsd.Growing(path, self.length, self.settings.precision)
            else:
                self._trajectory = _GrowingText(path, self.length, format)

    @property
    def samples_path(self) -> str:
        """The file of samples until the run ends. Each checkpoint adds samples to it."""
        return self.path + ".samples"

    @property
    def _table_path(self) -> str:
        return self.path.removesuffix(".h5")

    def _open_samples(self) -> None:
        if self.settings.has_table:
            _check_length(self._table_path, self.table_length, "table")
            with self._explaining(self._table_path):
                _append(self._table_path, self.table_length, b"")
        if self._finished is not None:
            with self._explaining(self.samples_path):
                _append(self.samples_path, 0, self._finished.tobytes())
            self._finished = None
            return
        size = self.saved * _ROW.itemsize
        _check_length(self.samples_path, size, "samples")
        if size and checksum(self.samples_path, size) != self.checksum:
            raise FileError(self.samples_path, f"was changed after pw85 mc had written it: {_CURE}")

    def _append_samples(self) -> None:
        """Writes the samples since the last checkpoint behind those that are there."""
        new = np.array(self.rows, _ROW).tobytes()
        if new:
            with self._explaining(self.samples_path):
                _append(self.samples_path, self.saved * _ROW.itemsize, new)
        if self.settings.has_table:
            with self._explaining(self._table_path):
                if not self.table_length:
                    _add_line(self._table_path, ",".join(_ROW.names or ()))
                self.table_length = _synced(self._table_path)
        self.saved, self.checksum, self.rows = self.saved + len(self.rows), zlib.crc32(new, self.checksum), []

    def close(self) -> None:
        """Closes the trajectory. What is not written yet belongs to no checkpoint."""
        if self._trajectory is not None:
            with contextlib.suppress(OSError):
                self._trajectory.close()

    def save(self, is_last: bool = False) -> None:
        """Writes a checkpoint. If that fails, the one before stays. The last one has all samples, whose file goes away."""
        if self._trajectory is not None:
            with self._explaining(self._trajectory.name):
                self.length = self._trajectory.sync()
        self._append_samples()
        with self._explaining(self.path):
            _write_durably(self.path, self._content(is_last))
        if is_last and os.path.exists(self.samples_path):
            os.unlink(self.samples_path)

    @contextlib.contextmanager
    def _explaining(self, path: str) -> Iterator[None]:
        """Says what is left of a run if a file cannot be written."""
        try:
            yield
        except OSError as error:
            last = [f"continue from the last checkpoint (--resume {self.path})"] if os.path.exists(self.path) else []
            cure = ["make room"] if error.errno in _NO_ROOM else ["name a file in another folder"] if not last else []
            raise FileError(path, f"{error.strerror}: {', and '.join(cure + last)}") from None

    def _beside(self, name: str) -> str:
        return os.path.join(os.path.dirname(self.path), name)

    def _content(self, has_samples: bool) -> bytes:
        """A file of HDF5 with the last configuration as in H5MD, and everything else in a group of its own."""
        import h5py

        buffer = io.BytesIO()
        FORMATS["hdf5"].save(buffer, iter([self.system()]))
        with h5py.File(buffer, "r+") as file:
            group = file.create_group(_GROUP)
            group.attrs["format"] = _FORMAT
            group.attrs["version"] = version()
            group.attrs["settings"] = json.dumps(self.settings._asdict())
            group["state"] = np.frombuffer(self.simulation.save(), np.uint8)
            progress = self.equilibrated, self.sweeps, self.length, self.table_length, self.saved, self.checksum
            group["progress"] = np.array(progress, np.int64)
            group["corner"] = self.corner
            length = self.settings.chain_length
            group["chain_length"] = np.nan if length is None else length
            if has_samples:
                group["samples"] = np.fromfile(self.samples_path, _ROW, self.saved) if self.saved else np.empty(0, _ROW)
            for name, numbers in self.observables.state().items():
                group[f"observables/{name}"] = numbers
            for name, numbers in ({} if self.equilibration is None else self.equilibration.state()).items():
                group[f"equilibration/{name}"] = numbers
            self._write_results(group)
            group.attrs["digest"] = _digest(file)
        return hdf5.sealed(buffer.getvalue())

    def _write_results(self, group: Any) -> None:
        kinds = [("name", "S32"), ("value", "f8"), ("error", "f8"), ("samples", "f8")]
        group["averages"] = np.array([(name, *one) for name, one in self.averages().items()], np.dtype(kinds))
        group["director"] = self.observables.director()
        for move, counts in self.simulation.counts.items():
            group[f"counts/{move}"] = np.array(counts, np.int64)
        pairs = self.observables.pair_correlation()
        if pairs is not None:
            for name, numbers in pairs._asdict().items():
                group[f"pair_correlation/{name}"] = numbers


def _digest(file: Any) -> str:
    """SHA-256 of all numbers and names in a file of a run. Bits that have changed on a disk would make another trajectory."""
    digest = hashlib.sha256(file[_GROUP].attrs["settings"].encode())

    def add(name: str, thing: Any) -> None:
        if hasattr(thing, "shape"):  # no group
            content = np.asarray(thing[()])
            text = repr(content.tolist()).encode() if content.dtype.hasobject else content.tobytes()
            digest.update(f"{name} {content.shape} {len(text)} ".encode() + text)

    file.visititems(add)
    return digest.hexdigest()


def _kinds(simulation: HardEllipsoids) -> list[bytes]:
    """The semi-axes of each particle, as something to compare and to look up."""
    return [axes.tobytes() for axes in simulation.semi_axes]


def _check_length(path: str, length: int, what: str) -> None:
    size = os.path.getsize(path) if os.path.exists(path) else 0
    if size < length:
        raise FileError(path, f"is shorter than at the checkpoint, {length} bytes: bring back the {what} of this run")


def _append(path: str, place: int, content: bytes) -> None:
    """Writes bytes at a place of a file, which ends there, and waits until they are on the disk."""
    with open(path, "r+b" if os.path.exists(path) else "wb") as file:
        file.truncate(place)
        file.seek(place)
        file.write(content)
        file.flush()
        os.fsync(file.fileno())


def _add_line(path: str, line: str) -> None:
    """Adds a line to a table, where other programs see it at once."""
    with open(path, "a", encoding="utf-8", newline="\n") as file:
        file.write(line + "\n")


def _synced(path: str) -> int:
    """Waits until a file is on the disk, and says how long it is."""
    with open(path, "r+b") as file:
        os.fsync(file.fileno())
        return os.fstat(file.fileno()).st_size


def _write_durably(path: str, content: bytes) -> None:
    """Writes a new file, waits until it is on the disk, and puts it in the place of the old one."""
    with replacing(path) as temporary, open(temporary, "wb") as file:
        file.write(content)
        file.flush()
        os.fsync(file.fileno())


@contextlib.contextmanager
def locked(path: str) -> Iterator[None]:
    """Holds the file of a run, so that no other process continues it at the same time. The file itself is replaced at each checkpoint, so
    the lock is on another one, which is removed at the end. If the process is killed, the system takes the lock away."""
    if fcntl is None:
        yield
        return
    path = os.path.realpath(path)
    name = os.path.join(os.path.dirname(path), f".{os.path.basename(path)}.lock")
    file = _open_locked(path, name)
    try:
        yield
    finally:
        with contextlib.suppress(OSError):
            os.unlink(name)
        os.close(file)


def _open_locked(path: str, name: str) -> int:
    while True:
        try:
            file = os.open(name, os.O_RDWR | os.O_CREAT, 0o666)
        except OSError as error:
            raise FileError(path, f"{error.strerror}: name a file in another folder") from None
        try:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
            if os.path.exists(name) and os.path.samestat(os.fstat(file), os.stat(name)):
                return file
        except BlockingIOError:
            os.close(file)
            raise FileError(path, "another process is at work on this run: wait for its end, or interrupt it") from None
        except OSError:  # a disk without locks
            return file
        os.close(file)  # the process that had the lock has just removed the file


def resume(path: str) -> Run:
    """The run of a file, at its last checkpoint. A file that is broken cannot be written again, as the readers of formats advise."""
    with open(path, "rb") as file:
        if file.read(len(_SIGNATURE)) != _SIGNATURE[: os.path.getsize(path)]:
            raise FileError(path, _NO_RUN)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # the command has said what was taken of the file when the run began
            return _read(path, read(path, format="hdf5"))
    except FileError as error:
        raise FileError(path, error.reason.replace("write it again", _CURE)) from None


@guarded
def _read(path: str, particles: System) -> Run:
    with hdf5.opened(path) as file:
        if _GROUP not in file:
            raise FileError(path, _NO_RUN)
        group = file[_GROUP]
        if group.attrs.get("format", 0) != _FORMAT:
            other = group.attrs["version"]
            raise FileError(path, f"is a run of pypw85 {other} in a format that {version()} does not read: continue it with that version")
        if group.attrs["digest"] != _digest(file):
            raise FileError(path, f"was changed after pw85 mc had written it: {_CURE}")
        settings = Settings(**json.loads(group.attrs["settings"]))
        length = float(group["chain_length"][()])
        settings = settings._replace(chain_length=None if np.isnan(length) else length)
        observables = Observables.restore({name: data[()] for name, data in group["observables"].items()})
        particles.origin = group["corner"][()]
        run = Run(path, settings, particles, HardEllipsoids.restore(group["state"][()].tobytes()), observables)
        run.equilibrated, run.sweeps, run.length, run.table_length, run.saved, run.checksum = group["progress"][()].tolist()
        if run.equilibration is not None:
            run.equilibration = Equilibration.restore({name: data[()] for name, data in group["equilibration"].items()})
        run._finished = group["samples"][()] if "samples" in group else None
        return run
