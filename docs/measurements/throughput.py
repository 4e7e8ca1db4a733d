"""Time per pair on one thread, as CSV.

Usage: throughput.py > throughput.csv

Random general ellipsoids, half of the pairs overlapping; blocks of 4096 pairs, which stay in the cache; the best of
several repetitions. Each SIMD target is forced in a process of its own; one that the processor does not have is left
out. The reference, contact_function, is called through NumPy too, which adds some nanoseconds to each pair.
"""

import csv
import os
import subprocess
import sys
import time

import numpy as np
import pypw85

PAIRS = 4096
ASPECTS = (2, 10, 100)
FLAGS = {"baseline": set(), "avx2": {"avx2", "fma"}, "avx512": {"avx2", "fma", "avx512f", "avx512dq", "avx512vl"}}


def random_forms(random, aspect):
    semi_axes = np.stack([np.ones(PAIRS), aspect ** -random.random(PAIRS), np.full(PAIRS, 1 / aspect)], axis=1)
    return pypw85.ellipsoid_quaternion(semi_axes, random.standard_normal((PAIRS, 4)))


def random_pairs(aspect):
    """Pairs with μ between 0.9 and 1.1."""
    random = np.random.default_rng(1985)
    q1, q2 = random_forms(random, aspect), random_forms(random, aspect)
    r12 = random.standard_normal((PAIRS, 3))
    mu = random.uniform(0.9, 1.1, PAIRS)
    return r12 * (mu / np.sqrt(pypw85.contact(r12, q1, q2)[0]))[:, np.newaxis], q1, q2


def nanoseconds_per_pair(function, pairs, out, seconds=1.0):
    best, end = np.inf, time.perf_counter() + seconds
    while time.perf_counter() < end:
        start = time.perf_counter()
        function(*pairs, out=out)
        best = min(best, time.perf_counter() - start)
    return 1e9 * best / PAIRS


def measure(target):
    writer = csv.writer(sys.stdout, lineterminator="\n")
    two = (np.empty(PAIRS), np.empty(PAIRS))
    functions = {"contact": (pypw85.contact, two), "overlap": (pypw85.overlap, np.empty(PAIRS, dtype=bool))}
    if target == "baseline":
        functions["contact_function"] = (pypw85.contact_function, two)
    for name, (function, out) in functions.items():
        times = [nanoseconds_per_pair(function, random_pairs(aspect), out) for aspect in ASPECTS]
        writer.writerow([name, target] + [f"{float(f'{t:.3g}'):g}" for t in times])


def processor_flags():
    try:
        with open("/proc/cpuinfo") as info:
            return next((set(line.split(":")[1].split()) for line in info if line.startswith("flags")), set())
    except OSError:
        return set()


def main():
    if len(sys.argv) > 1:
        measure(sys.argv[1])
        return
    print("function,target," + ",".join(f"aspect_{aspect}" for aspect in ASPECTS), flush=True)
    available = processor_flags()
    for target, flags in FLAGS.items():
        if flags <= available:
            environment = dict(os.environ, PW85_TARGET=target, OMP_NUM_THREADS="1")
            subprocess.run([sys.executable, __file__, target], env=environment, check=True)


main()
