"""Replica exchange in pressure, by several processes.

Usage: replica_exchange.py [PROCESSES]. Their number does not change the results.
"""

import contextlib
import math
import multiprocessing
import os
import sys

import numpy as np
import pypw85


def settle(job):
    """A replica that has come to equilibrium at a pressure, with steps for it."""
    replica, pressure = job
    replica.tune(400, pressure=pressure)
    return replica


def advance(job):
    """A replica after some sweeps at a pressure, by any process."""
    replica, pressure, steps, sweeps = job
    replica.set_steps(*steps)
    for _ in range(sweeps):
        replica.sweep()
        replica.volume_moves(3, pressure)
    return replica


def exchange(replicas, pressures, rounds, sweeps, seed, processes=1):
    """Moves replicas at pressures βP, which are exchanged after rounds of sweeps.

    Returns the volumes and the numbers of the replicas, (rounds, pressures); which part
    of the exchanges of neighbours was accepted; and the replicas.
    """
    random, n = np.random.default_rng(seed), len(pressures)
    order, volumes, orders = list(range(n)), [], []
    tried, accepted = np.zeros(n - 1), np.zeros(n - 1)
    with contextlib.ExitStack() as stack:
        map_all = map
        if processes > 1:
            context = multiprocessing.get_context("spawn")
            map_all = stack.enter_context(context.Pool(processes)).imap
        replicas = list(map_all(settle, zip(replicas, pressures)))
        steps = [replica.steps for replica in replicas]  # they belong to the pressures
        for k in range(rounds):
            jobs = zip(replicas, pressures, steps, [sweeps] * n)
            replicas = list(map_all(advance, jobs))
            v = [replica.system().volume for replica in replicas]
            volumes.append(tuple(v))
            orders.append(tuple(order))
            # In turn the pairs (0, 1), (2, 3), … and (1, 2), (3, 4), …
            for i in range(k % 2, n - 1, 2):
                exponent = (pressures[i] - pressures[i + 1]) * (v[i] - v[i + 1])
                tried[i] += 1
                if random.random() < math.exp(min(exponent, 0)):
                    accepted[i] += 1
                    for row in (replicas, order):
                        row[i], row[i + 1] = row[i + 1], row[i]
    parts = accepted / np.maximum(tried, 1)
    return np.array(volumes), np.array(orders), parts, replicas


NUMBER, AXES = 27, np.array([0.5, 0.5, 1.0])
SIZE = pypw85.volume(pypw85.ellipsoid_quaternion(AXES, [1, 0, 0, 0]))


def fluid(seed, fraction=0.3):
    """Spheroids of aspect ratio 2, on a lattice."""
    edges = AXES * (SIZE / fraction / AXES.prod()) ** (1 / 3)
    grid = np.meshgrid(*[np.arange(3)] * 3)
    places = edges * np.stack(grid, axis=-1).reshape(-1, 3)
    axes, upright = np.tile(AXES, (NUMBER, 1)), np.tile([1, 0, 0, 0], (NUMBER, 1))
    cell = 3 * np.diag(edges)
    lattice = pypw85.System.from_axes(places, axes, upright, cell=cell)
    return pypw85.HardEllipsoids(lattice, seed=seed)


def main():
    # One thread in each process, and the same numbers on every machine
    os.environ.update(OMP_NUM_THREADS="1", PW85_REPRODUCIBLE="1")
    pypw85.set_reproducible(True)
    processes = int(sys.argv[1]) if len(sys.argv) > 1 else 2
    pressures = [2.0, 2.3, 2.6, 3.0]
    volumes, orders, parts, replicas = exchange(
        [fluid(seed) for seed in range(len(pressures))],
        pressures,
        rounds=800,
        sweeps=10,
        seed=1,
        processes=processes,
    )
    for pressure, column, order in zip(pressures, volumes.T, orders.T):
        fractions = pypw85.Blocking()
        for volume in column:
            fractions.add(NUMBER * SIZE / volume)
        (value,), (error,), _ = fractions.estimate()
        print(f"βP = {pressure}: packing fraction {value:.3f} ± {error:.3f},", end=" ")
        print(f"{len(set(order))} replicas were there")
    print("exchanges accepted:", *(f"{part:.2f}" for part in parts))
    for replica in replicas:
        replica.check()


if __name__ == "__main__":
    main()
