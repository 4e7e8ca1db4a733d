# SPDX-License-Identifier: BSD-3-Clause
"""Trials per second of `pw85 mc`, and errors of the pressure for its time, by how samples are taken: python3 measure_samples.py [SWEEPS]

Prints CSV. Each row is a run of 500 particles from an equilibrated state, for the time that `SWEEPS` sweeps take alone, with its trials in
10⁶ per processor second, and these over those of sweeps alone. An error is that of the mean Z of the run, from the scatter of 32 parts of
it, times the root of the processor seconds of the run; it is itself uncertain by 13 %. The samples of the command without options are
marked.
"""

import csv
import sys
import time

import numpy as np

import pypw85
from pypw85 import _core
from pypw85._lattices import lattice
from pypw85._observables import Sample
from pypw85.cli._runs import Run, Sampling, Settings, usual_sampling

SWEEPS = 40_000
PARTS = 32
NUMBER = 500
# State, semi-axes, packing fraction and lattice of the start, if there is one. The lattice of ellipsoids melts to a nematic fluid.
STATES = [
    ("isotropic", (0.5, 0.5, 1.5), 0.4, None),
    ("isotropic", (0.5, 0.5, 1.5), 0.5, None),
    ("nematic", (0.5, 0.5, 1.5), 0.58, "stretched"),
    ("crystal of spheres", (0.5, 0.5, 0.5), 0.7, "fcc"),
]
# Sweeps between two samples, and trials for each chain. Chains are as long as without options.
SAMPLINGS = [(10, 250), (20, 250), (20, 1000), (50, 1000)]
COLUMNS = "state", "fraction", "z", "default", "every", "chains", "rate", "of_engine", "error_of_chains", "error_of_contacts"


def equilibrated(semi_axes, fraction, kind, sweeps):
    """A simulation of a state, after a third of the sweeps."""
    if kind is None:
        start = pypw85.pack(np.tile(semi_axes, (NUMBER, 1)), fraction, seed=1)
    else:
        start = lattice(semi_axes, fraction, NUMBER, kind, (0, 0, 1))
    simulation = pypw85.HardEllipsoids(start, seed=1)
    simulation.tune(sweeps // 3)
    return simulation


def run(state, sampling, seconds):
    """Makes sweeps for some processor seconds. Returns the run and these seconds."""
    settings = Settings(
        sweeps=sys.maxsize, equilibrate=0, seed=1, pressure=None, change="isotropic", trajectory=None, trajectory_format="",
        trajectory_every=1, has_table=False, **sampling._asdict(),
    )  # fmt: skip
    simulation = pypw85.HardEllipsoids.restore(state)
    made = Run("", settings, simulation.system(), simulation, pypw85.Observables())
    begin = time.process_time()
    while (used := time.process_time() - begin) < seconds:
        made.step()
    return made, used


def mean_and_error(made, name):
    """The mean of an average, and its error from equal parts of the run, longer than the correlations; NaN for too few samples."""
    samples = np.array([row[1 + Sample._fields.index(name)] for row in made.rows])
    if len(samples) < PARTS:
        return samples.mean(), np.nan
    means = samples[: len(samples) // PARTS * PARTS].reshape(PARTS, -1).mean(axis=1)
    return samples.mean(), means.std(ddof=1) / np.sqrt(PARTS)


def row_of(state, sampling, per_sweep, sweeps):
    """The numbers of a run: those of `COLUMNS` from z on."""
    made, seconds = run(state, sampling, sweeps * per_sweep)
    both = [mean_and_error(made, f"compressibility_{way}") for way in ("chains", "contacts")]
    rate = NUMBER * made.sweeps / seconds
    is_usual = sampling == usual_sampling(pypw85.HardEllipsoids.restore(state))
    errors = (f"{error * np.sqrt(seconds):.3g}" for _, error in both)
    of_engine = f"{rate * per_sweep / NUMBER:.2f}"
    return [f"{both[1][0]:.3g}", "yes" if is_usual else "", sampling.every, sampling.chains, f"{1e-6 * rate:.3g}", of_engine, *errors]


def main():
    sweeps = int(float(sys.argv[1])) if len(sys.argv) > 1 else SWEEPS
    _core.set_num_threads(1)
    table = csv.writer(sys.stdout)
    table.writerow(COLUMNS)
    for name, semi_axes, fraction, kind in STATES:
        simulation = equilibrated(semi_axes, fraction, kind, sweeps)
        state = simulation.save()
        begin = time.process_time()
        simulation.sweep(sweeps // 10)
        per_sweep = (time.process_time() - begin) / (sweeps // 10)
        length = usual_sampling(pypw85.HardEllipsoids.restore(state)).chain_length
        for every, trials in SAMPLINGS:
            sampling = Sampling(every, NUMBER * every // trials, length)
            table.writerow([name, fraction, *row_of(state, sampling, per_sweep, sweeps)])
            sys.stdout.flush()


if __name__ == "__main__":
    main()
