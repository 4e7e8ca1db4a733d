# SPDX-License-Identifier: BSD-3-Clause
"""Other threads run while arrays are computed, and processes may fork."""

import concurrent.futures
import multiprocessing
import subprocess
import sys
import sysconfig
import threading

import numpy as np
import pytest

import pypw85
from pypw85 import legacy


def work(pairs):
    """A call that takes a while in one thread: no function of many pairs is behind it."""
    legacy.contact_function2(*pairs)


def test_gil_is_released(random_pairs):
    """While one thread is in a loop of the extension, another one runs Python.

    This needs no second processor and no quiet machine: with the GIL held, the other thread could not count at all
    between start and end of the call.
    """
    pairs = random_pairs(300_000)
    counts, stop = [0], threading.Event()

    def count():
        while not stop.is_set():
            counts[0] += 1

    counter = threading.Thread(target=count)
    counter.start()
    before = counts[0]
    work(pairs)
    during = counts[0] - before
    stop.set()
    counter.join()
    # Python counts millions per second, and the call takes some 0.2 s. Waiting for the GIL alone would give at most the
    # two switch intervals (5 ms) around the call.
    assert during > 100_000, during


def test_errors_of_threads_are_separate(random_pairs):
    good = random_pairs(1000)
    bad = (good[0], 0 * good[1], good[2])
    failures = []

    def check(pairs, expected):
        for _ in range(50):
            with np.errstate(invalid="raise"):
                try:
                    work(pairs)
                    failed = False
                except FloatingPointError:
                    failed = True
            if failed != expected:
                failures.append(expected)

    threads = [threading.Thread(target=check, args=args) for args in ((good, False), (bad, True), (good, False))]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not failures


def everything(seed):
    """What one thread computes: single pairs, arrays, lists of neighbours, a simulation, and text."""
    rng = np.random.default_rng(seed)
    q = pypw85.ellipsoid_quaternion(rng.uniform(0.5, 1, (60, 3)), rng.normal(size=(60, 4)))
    centers = rng.uniform(0, 6, (60, 3))
    pairs = pypw85.neighbors(centers, q, cell=6 * np.eye(3)).pairs
    r12 = centers[pairs[:, 1]] - centers[pairs[:, 0]]
    arrays = [*pypw85.contact(r12, q[pairs[:, 0]], q[pairs[:, 1]]), pypw85.overlap(r12, q[pairs[:, 0]], q[pairs[:, 1]])]
    single = [pypw85.contact(r12[k], q[pairs[k, 0]], q[pairs[k, 1]])[0] for k in range(20)]
    places = np.stack(np.meshgrid(*[np.arange(3.0)] * 3, indexing="ij"), axis=-1).reshape(-1, 3)
    spheres = pypw85.System.from_axes(places, np.full((27, 3), 0.3), np.tile([1.0, 0, 0, 0], (27, 1)), cell=3 * np.eye(3))
    simulation = pypw85.HardEllipsoids(spheres, seed=seed)
    simulation.sweep(5)
    return b"".join(np.ascontiguousarray(x).tobytes() for x in (pairs, *arrays, single, simulation.centers))


def test_threads_at_once_give_what_one_gives():
    """The same bits from many threads of Python that run everything at once. Without Python's lock, they do so in parallel."""
    seeds = list(range(1, 9))
    expected = [everything(seed) for seed in seeds]
    assert len(set(expected)) == len(seeds)
    interval = sys.getswitchinterval()
    sys.setswitchinterval(1e-5)  # with the lock, threads take turns within calls of the package
    try:
        with concurrent.futures.ThreadPoolExecutor(len(seeds)) as pool:
            for _ in range(5):
                assert list(pool.map(everything, seeds)) == expected
    finally:
        sys.setswitchinterval(interval)


def test_threads_share_arrays_and_a_simulation():
    """Threads read the same arrays, and calls of one simulation wait for each other: none is lost."""
    places = np.stack(np.meshgrid(*[np.arange(4.0)] * 3, indexing="ij"), axis=-1).reshape(-1, 3)
    spheres = pypw85.System.from_axes(places, np.full((64, 3), 0.3), np.tile([1.0, 0, 0, 0], (64, 1)), cell=4 * np.eye(3))
    alone, shared = (pypw85.HardEllipsoids(spheres, seed=5) for _ in range(2))
    alone.sweep(40)
    with concurrent.futures.ThreadPoolExecutor(8) as pool:
        list(pool.map(lambda _: shared.sweep(1), range(40)))
    assert np.array_equal(alone.centers, shared.centers)


@pytest.mark.skipif(not sysconfig.get_config_var("Py_GIL_DISABLED"), reason="this Python has a lock that cannot be off")
def test_lock_stays_off():
    """Python without its lock takes it again, with a warning, for an extension that does not say that it needs none."""
    code = "import sys, pypw85._core; sys.exit(sys._is_gil_enabled())"
    subprocess.run([sys.executable, "-c", code], check=True)


def sum_of_contacts(count):
    q = np.tile(pypw85.spheroid(1, 2, [0, 0, 1]), (count, 1))
    return pypw85.contact(np.tile([1.0, 2, 3], (count, 1)), q, q)[0].sum()


@pytest.mark.skipif("fork" not in multiprocessing.get_all_start_methods(), reason="no fork on this system")
def test_forked_process_does_not_hang():
    expected = sum_of_contacts(100_000)
    with multiprocessing.get_context("fork").Pool(1) as pool:
        assert pool.apply_async(sum_of_contacts, (100_000,)).get(timeout=60) == expected
