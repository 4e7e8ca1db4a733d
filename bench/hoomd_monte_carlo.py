# SPDX-License-Identifier: BSD-3-Clause
"""Measures HOOMD-blue's Monte Carlo on the inputs of public_monte_carlo.cpp, with one thread.

Usage: hoomd_monte_carlo.py [PARTICLES [INPUT]], the largest number of particles and the name of the only input. HOOMD-blue must be
importable; it is not in Debian. The rows have the columns of the other program. The start is made in the same way, by HOOMD-blue's own
moves and its QuickCompress, and repeated.
"""

import math
import sys
import time

import hoomd
import numpy as np

INPUTS = {"hoomd_benchmarks": (0.5, 0.03662120237875685, 0.019755985607527712), "hoomd_rs": (0.4, 0.19, 0.093)}
AXES = {"a": 2.5, "b": 0.5, "c": 0.5}
VOLUME = 4 / 3 * math.pi * 2.5 * 0.5 * 0.5
REPETITIONS = [(1, 1, 1), (2, 1, 1), (2, 2, 1), (2, 2, 2), (4, 2, 2), (4, 4, 2), (4, 4, 4)]
RANDOMIZING, RELAXING = 1000, 1000  # steps of four trials for each particle
SECONDS, SAMPLES = 0.25, 24


def simulation(integrator, snapshot):
    made = hoomd.Simulation(device=hoomd.device.CPU(notice_level=0), seed=1)
    made.create_state_from_snapshot(snapshot)
    made.operations.integrator = integrator
    return made


def ellipsoids(**steps):
    integrator = hoomd.hpmc.integrate.Ellipsoid(**steps)
    integrator.shape["A"] = AXES
    return integrator


def start(packing_fraction):
    """Some ellipsoids from a lattice, compressed."""
    places = np.stack(np.meshgrid(np.arange(8), np.arange(4), np.arange(4)), axis=-1).reshape(-1, 3) * 6.0
    snapshot = hoomd.Snapshot()
    snapshot.configuration.box = [48, 24, 24, 0, 0, 0]
    snapshot.particles.types, snapshot.particles.N = ["A"], len(places)
    snapshot.particles.position[:] = places - [24, 12, 12]
    made = simulation(ellipsoids(default_d=0.1, default_a=0.1), snapshot)
    made.run(RANDOMIZING)
    target = hoomd.Box.from_box(made.state.box)
    target.volume = len(places) * VOLUME / packing_fraction
    every = hoomd.trigger.Periodic(10)
    compress = hoomd.hpmc.update.QuickCompress(trigger=every, target_box=target)
    made.operations.updaters.append(compress)
    made.operations.tuners.append(
        hoomd.hpmc.tune.MoveSize.scale_solver(moves=["d"], target=0.2, trigger=every, max_translation_move=0.2)
    )
    while not compress.complete:
        made.run(100)
    return made.state.get_snapshot()


def measure(name, largest):
    packing_fraction, d, a = INPUTS[name]
    block = simulation(ellipsoids(default_d=d, default_a=a), start(packing_fraction))
    block.state.replicate(2, 2, 2)
    block.run(RELAXING)
    for times in REPETITIONS:
        if 1024 * math.prod(times) > largest:
            continue
        system = simulation(ellipsoids(default_d=d, default_a=a), block.state.get_snapshot())
        system.state.replicate(*times)
        row(name, system)


def row(name, system):
    """The most of several samples, by the time of the processor, as in the other program."""
    system.run(5)
    before = time.process_time()
    system.run(5)
    steps = max(5, round(5 * SECONDS / (time.process_time() - before)))
    best, accepted = 0.0, np.zeros((2, 2))
    for _ in range(SAMPLES):
        before = time.process_time()
        system.run(steps)
        seconds = time.process_time() - before
        moves = system.operations.integrator.translate_moves, system.operations.integrator.rotate_moves
        best, accepted = max(best, np.sum(moves) / seconds), accepted + moves
    parts = accepted[:, 0] / accepted.sum(axis=1)
    print(f"{name},{system.state.N_particles},{1e-6 * best:.3g},{parts[0]:.2f},{parts[1]:.2f}", flush=True)


def main():
    largest = float(sys.argv[1]) if len(sys.argv) > 1 else 65536
    print("input,particles,per_second,translations,rotations")
    for name in INPUTS:
        if len(sys.argv) < 3 or sys.argv[2] == name:
            measure(name, largest)


if __name__ == "__main__":
    main()
