"""Other threads run while arrays are computed, and processes may fork."""

import multiprocessing
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


def sum_of_contacts(count):
    q = np.tile(pypw85.spheroid(1, 2, [0, 0, 1]), (count, 1))
    return pypw85.contact(np.tile([1.0, 2, 3], (count, 1)), q, q)[0].sum()


@pytest.mark.skipif("fork" not in multiprocessing.get_all_start_methods(), reason="no fork on this system")
def test_forked_process_does_not_hang():
    expected = sum_of_contacts(100_000)
    with multiprocessing.get_context("fork").Pool(1) as pool:
        assert pool.apply_async(sum_of_contacts, (100_000,)).get(timeout=60) == expected
