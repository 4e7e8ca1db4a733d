# SPDX-License-Identifier: BSD-3-Clause
"""``pw85 mc``: Monte Carlo of hard ellipsoids."""

from __future__ import annotations

import contextlib
import os
import sys
import time
from functools import partial
from typing import Any
from collections.abc import Callable, Iterator

import click
import numpy as np

from .. import _core
from .._blocking import LEAST_INDEPENDENT
from .._observables import MOST_BINS, Observables
from .._simulations import HardEllipsoids, is_bulk, name_pairs
from .._statistics import pair_correlation
from .._system import UNIT_BALL, System
from .._words import counted
from ..formats import FORMATS, FileError, check_output, check_storable, refuse_standard_output
from ._input import Finite, Input, WholeNumber, command, given_options, input_options, one_frame, refuse_given, refuse_idle
from ._interruption import keeping_work
from ._progress import progress, say
from ._runs import (
    ACCEPTANCE,
    DENSE,
    EVERY,
    EVERY_OF_DENSE,
    LONGEST_PATH,
    PATHS,
    TRIALS_PER_CHAIN,
    TRIALS_PER_CHAIN_OF_DENSE,
    Run,
    Settings,
    locked,
    resume,
)
from ._surroundings import FIELD, LAW, WALL, Surrounding, refuse_idle_fields, set_law, surround

_START = partial(input_options, argument=click.argument("file", required=False, metavar="[START]"))
# What may be given with --resume
_OF_RESUMED = {"resumed", "sweeps", "threads", "checkpoint"}
# Options that have no effect without others
_NEEDED = {
    "volume": ["pressure"], "volume_trials": ["pressure"], "trajectory_every": ["trajectory"], "precision": ["trajectory"],
    "bins": ["reach"],
}  # fmt: skip
# Each thread needs a stack. OpenMP ends the process if it cannot start one.
MOST_THREADS = 1024
# Free paths of all chains of a sample, before whose end Ctrl-C has no effect. Each takes about a microsecond or more.
_MOST_PATHS = 10**8
# Volume moves after a sweep, before whose end Ctrl-C has no effect, either. Each takes about as long as a sweep.
_MOST_VOLUME_TRIALS = 10**4


@command(short_help="Move hard ellipsoids by Monte Carlo, and print averages with errors.")
@_START
@click.option("--sweeps", type=WholeNumber(), metavar="N",
              help="Number of sweeps of the run, such as 1e5. A sweep has as many trial moves as there are particles.")
@click.option("--out", metavar="FILE",
              help="Write the run to this file, which must not exist. NAME.h5 contains the averages, the samples and the checkpoint. "
                   "With NAME.csv the samples are in this table, and the rest is in NAME.csv.h5.")
@click.option("--pressure", type=Finite(), metavar="P",
              help="Constant reduced pressure βP = P/(k_B T), in the inverse cube of the unit of length of START (in two dimensions, "
                   "the inverse square). Without this option the volume is constant.")
@click.option("--volume", type=click.Choice(["isotropic", "axis", "triclinic"]), default="isotropic", show_default=True,
              help="With --pressure: what a volume move does to the cell. isotropic: it scales all axes by the same factor; axis: it "
                   "scales one axis; triclinic: it scales one axis or shears the cell. Use axis and triclinic only for crystals: in a "
                   "fluid the cell becomes longer and thinner without limit.")
@click.option("--volume-trials", type=WholeNumber(most=_MOST_VOLUME_TRIALS), default=1, show_default=True, metavar="N",
              help="With --pressure: number of volume moves after each sweep.")
@click.option("--exchange", type=Finite(may_be_zero=True, below=1), default="0", show_default=True, metavar="FRACTION",
              help="For mixtures: fraction of the trial moves that exchange the semi-axes of two particles of different species.")
@click.option("--wall", "walls", type=WALL, multiple=True, metavar="KIND:NUMBER,...",
              help=f"A hard wall: {WALL.forms()}. A plane fills the half-space N·x > OFFSET, and particles are on the other side. "
                   "A cylinder is infinitely long, and has the axis AX,AY,AZ through the point X,Y,Z. A box has the corners LX,LY,LZ and "
                   "UX,UY,UZ. Particles are inside spheres, cylinders and boxes. A wall must be parallel to all periodic cell vectors: see "
                   "--periodic. May be repeated.")
@click.option("--field", "fields", type=FIELD, multiple=True, metavar="KIND:NUMBER,...",
              help=f"An external field: {FIELD.forms()}. The energy U of a particle of volume V with the centre r is, in units of kT, G·r "
                   "(linear); V G·r (weight); Σ K (r - X)²/2 over x, y and z (harmonic); -STRENGTH (3 cos²θ - 1)/2 with the angle θ "
                   "between D and the principal axis AXIS, 0, 1 or 2 (aligning; default: 2). A field must not change along the "
                   "periodic cell vectors: see --periodic. May be repeated.")
@click.option("--law", type=LAW, metavar="KIND:...",
              help="Pair potential U(μ) outside the hard cores, in units of kT; μ is 1 at contact. powers:A,N,B,M,MU2_MAX: U is "
                   "A μ^-N - B μ^-M minus its value at the cutoff μ² = MU2_MAX, and 0 beyond it. table:FILE: each line of FILE has "
                   "three numbers, μ², U and dU/dμ², with equal steps of μ²; U is 0 beyond the last line.")
@click.option("--equilibrate", type=WholeNumber(0), metavar="N",
              help="Number of sweeps before the run, in addition to --sweeps. They bring the system to equilibrium and tune the step "
                   "sizes, and do not count for averages. By default they end as soon as no average drifts, and at the latest after "
                   "15/16 of --sweeps.")
@click.option("--every", type=WholeNumber(), metavar="N",
              help=f"Number of sweeps between two samples. Default: {EVERY}, or {EVERY_OF_DENSE} in dense systems (βP/ρ >= {DENSE}).")
@click.option("--chains", type=WholeNumber(0), metavar="N",
              help="Number of event chains at each sample, from which the pressure is computed; 0: none. Default: one for every "
                   f"{TRIALS_PER_CHAIN} trial moves between two samples, or for every {TRIALS_PER_CHAIN_OF_DENSE} in dense systems; none "
                   "with --wall, --field or --law, which event chains do not support.")
@click.option("--chain-length", type=Finite(), metavar="L",
              help=f"Length of each event chain: the sum of its displacements. Default: a length with about {PATHS} collisions.")
@click.option("--seed", type=WholeNumber(0, 2**64 - 1), default=1, show_default=True, help="Seed of the random numbers.")
@click.option("--width", type=Finite(most=1.0), default="0.1", show_default=True,
              metavar="NUMBER",
              help="The pressure from contacts is extrapolated from the pairs with μ - 1 below this number, at most 1.")
@click.option("--reach", type=Finite(may_be_zero=True), default="0", show_default=True,
              metavar="DISTANCE",
              help="Largest distance of the pair correlation g(r), which is written to the file of the run; 0: no pair correlation.")
@click.option("--bins", type=WholeNumber(most=MOST_BINS), default=50, show_default=True, metavar="N",
              help="With --reach: number of bins of the pair correlation.")
@click.option("--trajectory", metavar="FILE", help="Also write configurations to this file, which must not exist (.gsd, .xyz or .dump).")
@click.option("--trajectory-every", type=WholeNumber(), default="1000", show_default=True, metavar="N",
              help="Number of sweeps between two configurations of --trajectory.")
@click.option("--precision", type=click.Choice(["single", "double"]), default="double", show_default=True,
              help="Precision of a trajectory in GSD. HOOMD-blue reads double precision since version 7; its Python module gsd.hoomd "
                   "may refuse it, gsd.fl does not.")
@click.option("--checkpoint", type=Finite(may_be_zero=True), default="60", show_default=True, metavar="SECONDS",
              help="Time between two checkpoints, from which --resume continues an interrupted run.")
@click.option("--threads", type=WholeNumber(most=MOST_THREADS), help="Number of threads. It does not change the results.")
@click.option("--resume", "resumed", metavar="FILE",
              help="Continue the run of this file. --sweeps, if given, is the new total number of sweeps.")
@click.pass_context
def mc(ctx: click.Context, /, given: Input | None, sweeps: int | None, checkpoint: float, threads: int | None,
       resumed: str | None, **others: Any) -> int:  # fmt: skip
    """Simulate hard ellipsoids by Monte Carlo, and print averages with their standard errors. The run starts from the first chosen frame
    of START, which must have no overlaps (pw85 pack and pw85 relax write such files). In two dimensions ellipses move in their plane, and
    areas replace volumes.

    A new run needs START, --sweeps and --out. After Ctrl-C the command finishes the sweep, writes a checkpoint, and ends with status 130.
    Then --resume continues the run. The result is bitwise equal to that of an uninterrupted run.
    """
    if threads is not None:
        _core.set_num_threads(threads)
    with contextlib.ExitStack() as held:
        if resumed is None:
            _refuse_without_effect(ctx)
            run = _start(held, given, sweeps, **others)
        else:
            _refuse_others()
            run = _continued(held, resumed, sweeps)
        held.enter_context(contextlib.closing(run))
        with keeping_work(), progress() as stage:
            run.open()
            status = _go(run, checkpoint, stage)
    if status:
        say(f"pw85: interrupted after {_sweeps(run)}: continue with pw85 mc --resume {run.path}", sys.stderr)
    else:
        _report(run)
    return status


def _refuse_others() -> None:
    others = [text for name, text in given_options().items() if name not in _OF_RESUMED]
    if others:
        raise click.UsageError("with --resume, only --sweeps, --threads and --checkpoint can change, and the file has the rest: "
                               f"leave out {', '.join(others)}")  # fmt: skip


def _refuse_without_effect(ctx: click.Context) -> None:
    """Refuses options that would have no effect."""
    given, chains = given_options(), ctx.params["chains"]
    for name in {"chains", "chain_length"} & set(given):
        if ctx.params[name] and (ctx.params["walls"] or ctx.params["fields"] or ctx.params["law"]):
            raise click.UsageError(f"event chains do not support walls, fields and laws: leave out {given[name]}")
    refuse_idle(_NEEDED if chains is None else _NEEDED | {"chain_length": ["chains"]})


def _refuse_long_steps(sweeps: int, every: int | None, trajectory_every: int | None) -> None:
    """Refuses distances of samples and of frames that none of the sweeps reaches. The default distance of samples is for longer runs."""
    for option, number in {"--every": every, "--trajectory-every": trajectory_every}.items():
        if number is not None and number > sweeps:
            raise click.UsageError(f"{option} must be at most --sweeps, {sweeps}, not {number}: nothing would be written")


def _continued(held: contextlib.ExitStack, name: str, sweeps: int | None) -> Run:
    """The run of a file, which no other process continues as long as the stack holds it."""
    path = _run_file(name)[0] if name.endswith(".csv") else name
    check_output(path)
    if os.path.exists(path):
        held.enter_context(locked(path))
    run = resume(path)
    if sweeps is not None and sweeps < run.sweeps:
        raise FileError(path, f"has {run.sweeps} sweeps already: ask for more (--sweeps)")
    run.settings = run.settings._replace(sweeps=sweeps or run.settings.sweeps)
    return run


def _start(held: contextlib.ExitStack, given: Input | None, sweeps: int | None, *, out: str | None, trajectory: str | None,
           width: float, reach: float, bins: int, **options: Any) -> Run:  # fmt: skip
    """A run from the command line, held as by _continued(). Its files can be written, and its first checkpoint is."""
    if given is None or sweeps is None or out is None:
        missing = [name for name, value in (("START", given), ("--sweeps", sweeps), ("--out", out)) if value is None]
        raise click.UsageError(f"give {' and '.join(missing)} for a new run, or --resume FILE to continue one")
    path, has_table = _run_file(out)
    growing = "" if trajectory is None else _growing_format(trajectory)
    if growing != "gsd":
        refuse_given("precision", "on a trajectory that is not a GSD file")
    for name in (path, out, trajectory, path + ".samples"):
        _refuse_existing(name)
    _refuse_long_steps(sweeps, options["every"], None if trajectory is None else options["trajectory_every"])
    system = _checked(given, one_frame(given, sys.stdout), bool(options["walls"] or options["fields"]))
    if options["exchange"]:
        _check_exchange(given, system)
    if not is_bulk(system):
        _refuse_averages_of_bulk(system, pressure=options["pressure"], reach=reach)
        refuse_given("width", f"without a cell that is periodic along its {_vectors(system)} vectors, because there is no pressure")
    refuse_idle_fields(given.path, system.dimensions, options["fields"])
    settings = _settings(system, path, trajectory, sweeps=sweeps, trajectory_format=growing, has_table=has_table, **options)
    observables = Observables(width, reach, bins)
    if reach:
        _check_reach(system, reach, bins)
    _refuse_long_chains(system, options["chains"], options["chain_length"])
    held.enter_context(locked(path))
    _refuse_existing(path)
    simulation = _simulation(given.path, system, **options)
    if trajectory is not None:
        check_storable(trajectory, growing, system, **({"precision": settings.precision} if growing == "gsd" else {}))
    if system.cell is not None:
        system.origin = system.origin @ np.linalg.inv(system.cell)
    run = Run(path, settings, system, simulation, observables)
    if settings.pressure is not None:
        run.check_cell()
    run.save()
    return run


def _check_reach(system: System, reach: float, bins: int) -> None:
    """Refuses a pair correlation that memory cannot hold, before the run has a file."""
    try:
        pair_correlation(system, reach, bins)
    except MemoryError:
        raise ValueError(f"there is not enough memory for all pairs within --reach, {reach:g}: choose a smaller one") from None


def _refuse_long_chains(system: System, chains: int | None, length: float | None) -> None:
    """Refuses chains that would run for minutes at each sample. None is a choice of the command: of a length with PATHS free paths."""
    longest_path = LONGEST_PATH * float(system.semi_axes[:, : system.dimensions].max())
    paths = (1 if chains is None else chains) * (PATHS if length is None else length / longest_path)
    if paths > _MOST_PATHS:
        raise click.UsageError(f"the event chains of a sample would have more than {paths:.2g} free paths, and at most {_MOST_PATHS:g} are "
                               "allowed: choose fewer --chains, or a smaller --chain-length")  # fmt: skip


def _settings(system: System, path: str, trajectory: str | None, *, volume: Any, every: int | None, chains: int | None,
              walls: tuple[Surrounding, ...], fields: tuple[Surrounding, ...], law: Surrounding | None,
              **others: Any) -> Settings:  # fmt: skip
    """The settings of a new run, from options of the command line."""
    return Settings(
        change=volume,
        every=every or 0,
        chains=0 if walls or fields or law else chains,
        trajectory=None if trajectory is None else os.path.relpath(trajectory, os.path.dirname(path) or "."),
        edges=() if system.cell is None else tuple(np.linalg.norm(system.cell[: system.dimensions], axis=1).tolist()),
        walls=tuple(wall.text for wall in walls),
        fields=tuple(field.text for field in fields),
        law=None if law is None else law.text,
        **others,
    )


def _simulation(path: str, system: System, *, seed: int, exchange: float, walls: tuple[Surrounding, ...], fields: tuple[Surrounding, ...],
                law: Surrounding | None, **_: Any) -> HardEllipsoids:  # fmt: skip
    """The particles of a new run, with what acts on them."""
    simulation = HardEllipsoids(system, seed)
    surround(path, system.ids, simulation, walls, fields)
    if law is not None:
        set_law(path, simulation, law)
    if exchange:
        simulation.set_fractions(translation=1 - exchange, rotation=1 - exchange, exchange=2 * exchange)
    return simulation


def _run_file(out: str) -> tuple[str, bool]:
    """The name of the file from which a run continues, and whether there is a table beside it."""
    refuse_standard_output(out, "a run continues from its file")
    if not out.endswith((".h5", ".hdf5", ".csv")):
        raise FileError(out, "is not a name of a run: end it with .h5 or .csv")
    has_table = out.endswith(".csv")
    return out + ".h5" if has_table else out, has_table


def _growing_format(trajectory: str) -> str:
    """The format of a trajectory, to which frames can be appended."""
    refuse_standard_output(trajectory, "a run that is continued adds to its trajectory")
    for name in ("gsd", "lammps-dump", "xyz"):
        if trajectory.lower().endswith(FORMATS[name].SUFFIXES):
            check_output(trajectory)
            return name
    raise FileError(trajectory, "a trajectory grows during the run: end its name with .gsd, .xyz or .dump (pw85 convert makes "
                    "others)")  # fmt: skip


def _refuse_existing(name: str | None) -> None:
    """No file is replaced: a run may have taken weeks."""
    if name is not None and os.path.lexists(check_output(name).path):
        raise FileError(name, "exists already: continue it (--resume), or name another file")


def _refuse_averages_of_bulk(system: System, **options: float | None) -> None:
    """Refuses what needs a volume that is the same everywhere."""
    for name, value in options.items():
        if value:
            raise click.UsageError(f"--{name} needs a cell that is periodic along its {_vectors(system)} vectors: leave it out")


def _vectors(system: System) -> str:
    """The number of vectors of the cell along which a system can be periodic."""
    return "three" if system.dimensions == 3 else "two"


def _checked(given: Input, system: System, is_surrounded: bool) -> System:
    """Refuses a start that makes no simulation."""
    if not is_surrounded and not is_bulk(system):
        letters = "abc"[: system.dimensions]
        raise FileError(given.path, f"the cell must be periodic along its {_vectors(system)} vectors: use --cell and --periodic {letters}, "
                        "or hold the particles by walls and fields (--wall, --field)")  # fmt: skip
    if system.shapeless:
        left = counted(system.shapeless, "particle without a shape is", "particles without a shape are")
        say(f"pw85: warning: {given.path}: {left} left out", sys.stderr)
    found = system.overlaps()
    if len(found.mu):
        raise FileError(given.path, f"{name_pairs(system.ids[found.pairs])}: separate them (pw85 relax), or enlarge the cell")
    return system


def _check_exchange(given: Input, system: System) -> None:
    """Exchanges need particles with different semi-axes. Types go with the semi-axes, so each species has one type."""
    _, kinds = np.unique(system.semi_axes, axis=0, return_inverse=True)
    names, types = np.unique(system.types, return_inverse=True)
    pairs = np.unique(np.stack([kinds.ravel(), types.ravel()]), axis=1)
    if kinds.max() == 0:
        raise FileError(given.path, "all particles have the same semi-axes: there is nothing to exchange (leave out --exchange)")
    twice = np.flatnonzero(np.diff(pairs[0]) == 0)
    if len(twice):
        one, other = names[pairs[1, twice[0] : twice[0] + 2]].tolist()
        raise FileError(given.path, f"particles of the types {one} and {other} have the same semi-axes: "
                        "give them one type, or leave out --exchange")  # fmt: skip


def _go(run: Run, checkpoint: float, stage: Callable[[str], None]) -> int:
    """Makes all sweeps, or those until Ctrl-C. Returns the status."""
    status, clock, saved = 0, _Clock(run), time.monotonic()
    try:
        stage("starting")
        while not run.is_finished:
            run.step()
            stage(clock.describe())
            if time.monotonic() - saved >= checkpoint:
                run.save()
                saved = time.monotonic()
    except KeyboardInterrupt:
        status = 130
    run.save(is_last=True)
    return status


class _Clock:
    """Says how far a run is, and how long the rest will take at this speed."""

    def __init__(self, run: Run) -> None:
        self._run, self._start, self._done = run, time.monotonic(), run.equilibrated + run.sweeps

    def describe(self) -> str:
        run = self._run
        done = run.equilibrated + run.sweeps
        left = run.most_equilibration + run.settings.sweeps - done
        seconds = int((time.monotonic() - self._start) / (done - self._done) * left)
        return f"{_sweeps(run)}, {seconds // 3600}:{seconds // 60 % 60:02}:{seconds % 60:02} left"


def _sweeps(run: Run) -> str:
    if not run.is_equilibrated:
        most = "" if run.equilibration is None else "at most "
        return f"{run.equilibrated} of {most}{run.most_equilibration} sweeps to equilibrate"
    return f"{run.sweeps} of {run.settings.sweeps} sweeps"


def _report(run: Run) -> None:
    """Prints acceptance and averages, and whether there are overlaps."""
    space, particle = ("volume", "particle") if run.simulation.dimensions == 3 else ("area", "ellipse")
    pressure = f"constant {space}" if run.settings.pressure is None else f"βP = {run.settings.pressure:g}"
    if not is_bulk(run.simulation):
        pressure = "not periodic along all vectors"
    say(f"{run.path}: {counted(len(run.simulation), particle)}, {pressure}, seed {run.settings.seed}")
    laws = () if run.settings.law is None else (run.settings.law,)
    for name, texts in (("wall", run.settings.walls), ("field", run.settings.fields), ("law", laws)):
        for text in texts:
            say(f"{name} {text}")
    say(f"{counted(run.equilibrated, 'sweep')} to equilibrate")
    for move, (trials, accepted) in run.simulation.counts.items():
        if trials:
            say(f"{accepted / trials:.3f} accepted of {trials} trials: {move}")
    for text in _units(run, space):
        say(text)
    if len(run.observables):
        say(_sampling(run))
        say("means of the samples, and standard errors of the means, by blocking because samples are correlated:")
        say(_LINE.format("", "value", "standard error", "independent samples"))
    else:
        say(f"no averages: a sample is taken every {run.settings.every} sweeps (--every)")
    drifting, unresolved = run.observables.drifting(), run.unresolved()
    for name, (value, error, samples) in run.averages().items():
        if not _is_printed(run, name):
            continue
        mark = "  ?" if name in drifting or name in unresolved else ""
        say(_LINE.format(name, f"{value:.8g}", _number(error, ".2g"), _number(samples, ".0f")) + mark)
    director = run.observables.director()
    if not np.isnan(director).any():
        say(" ".join(["director", *(f"{x:.4f}" for x in director[: run.simulation.dimensions])]))
    if run.settings.pressure is not None:
        say(" ".join(["cell edges", *(f"{edge:.6g}" for edge in run.edges())]))
    for text in _doubts(run):
        say(f"warning: {text}")
    run.simulation.check()
    say(f"no overlaps after {counted(run.sweeps, 'sweep')}")


def _units(run: Run, space: str) -> Iterator[str]:
    """Says the units of what is printed, and the pressure times the volume of a particle, which is a pure number."""
    system, power = run.simulation, "³" if run.simulation.dimensions == 3 else "²"
    parts = ["lengths in the unit L of START"]
    if is_bulk(system):
        parts += [f"{space} in L{power}, density in L⁻{power}"]
    parts += ["energy in kT"] * _is_printed(run, "energy")
    yield f"units: {', '.join(parts)}; other averages are pure numbers"
    if run.settings.pressure is not None:
        mean = UNIT_BALL[system.dimensions] * float(system.semi_axes[:, : system.dimensions].prod(axis=1).mean())
        yield (f"βP is in L⁻{power}; βP v0 = {run.settings.pressure * mean:.6g}, with the mean {space} v0 = {mean:.6g} L{power} of a "
               "particle")  # fmt: skip


def _is_printed(run: Run, name: str) -> bool:
    """Returns whether an average has a row of the table. The energy has none where nothing has an energy."""
    return name != "energy" or bool(run.settings.fields) or run.settings.law is not None


def _sampling(run: Run) -> str:
    """Says what each sample is made of, and what part of the time all of them took since the run began or continued."""
    every, count, length = run.settings.every, run.settings.chains, run.settings.chain_length
    chains = f" with {counted(count, 'event chain')} of length {length:.4g}" if count else ""
    text = f"a sample every {counted(every, 'sweep')}{chains}"
    seconds = run.seconds_of_samples + run.seconds_of_sweeps
    return text + (f"; samples took {run.seconds_of_samples / seconds:.0%} of the time" if run.seconds_of_samples else "")


# Steps are tuned to 0.4. Accepted parts outside these limits cost a factor of two or so of the work; they mean that the density around
# particles was another one when the steps were tuned.
_ACCEPTED = 0.2, 0.6
# Translations end at half the longest semi-axis, so in a dilute system more of them are accepted, whatever the tuning.
_LONGEST_STEP = 0.4


def _badly_tuned(run: Run) -> Iterator[str]:
    """Moves whose accepted part says that their steps were tuned in another state."""
    longest = float(run.simulation.semi_axes.max())
    for move in ("translation", "rotation"):
        trials, accepted = run.simulation.counts.get(move, (0, 0))
        if not trials or not run.equilibrated or (move == "rotation" and accepted == trials):  # of spheres
            continue
        is_limited = run.simulation.steps.translation > _LONGEST_STEP * longest
        if accepted < _ACCEPTED[0] * trials or (accepted > _ACCEPTED[1] * trials and not is_limited):
            yield f"{accepted / trials:.3f} of the {move}s were accepted instead of about {ACCEPTANCE:g}: "


def _unsettled(run: Run) -> Iterator[str]:
    """Says that the equilibration ended at its limit."""
    windows = run.equilibration
    names = [] if windows is None else [name for name in windows.unsettled() if name not in run.constants]
    if windows is not None and windows.is_finished and names:
        yield (f"the equilibration ended at its limit of {windows.sweeps} sweeps: in the last {windows.window} of them {', '.join(names)} "
               f"still changed, or had too few samples to tell: equilibrate longer (--equilibrate {2 * windows.sweeps})")  # fmt: skip


# A bias of the contacts beyond this many errors is not an accident.
_LARGEST_BIAS = 3.0


def _doubts(run: Run) -> Iterator[str]:
    """Says what makes the averages of a run doubtful."""
    averages = run.observables.stationary()
    unresolved, drifting, errors = run.unresolved(), run.observables.drifting(), run.averages()
    if unresolved and len(run.observables):
        yield (f"the run is too short for the errors of {', '.join(unresolved)}, which need {LEAST_INDEPENDENT} independent samples each, "
               "or it was not in equilibrium at its start: continue it (--resume, --sweeps)")  # fmt: skip
    if drifting:
        drifts = ", ".join(f"{name} by {drift:.1f} times its error" for name, drift in drifting.items())
        allowance = "" if any(np.isnan(errors[name].error) for name in drifting) else "; the errors in the table allow for this"
        yield f"drifts from the start to the end: {drifts}: begin again, equilibrate longer (--equilibrate){allowance}"
    yield from _unsettled(run)
    for text in _badly_tuned(run):
        yield text + "the steps were tuned before the system was in equilibrium: begin again, equilibrate longer (--equilibrate)"
    if run.settings.chains and len(run.observables) and "compressibility_chains" not in averages:
        yield "there is no pressure from chains: a particle could touch its own image, which chains do not see"
    bias = averages.get("contacts_bias")
    if bias is not None and abs(bias.value) > max(_LARGEST_BIAS * bias.error, averages["compressibility_contacts"].error):
        yield f"the width biases compressibility_contacts by about {bias.value:.2g}: choose a smaller one (--width)"
    elif bias is not None and bias.value == 0:
        yield "no pair was within the width: choose a larger one (--width)"
    if run.settings.pressure is not None and run.is_stretched:
        yield "the shape of the cell has changed much: use --volume axis and triclinic for crystals, and isotropic for fluids"


_LINE = "{:<24} {:>14} {:>14} {:>20}"


def _number(value: float, digits: str) -> str:
    """A minus sign alone for what cannot be known yet."""
    return "-" if np.isnan(value) else format(value, digits)
