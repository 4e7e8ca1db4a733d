# SPDX-License-Identifier: BSD-3-Clause
"""Elapsed time of a loop of the extension in one thread and shared by two, which the released GIL lets run side by side."""

import threading
import time

import numpy as np
import pypw85


def elapsed(parts):
    threads = [threading.Thread(target=pypw85.contact_function, args=part) for part in parts]
    start = time.perf_counter()
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    return time.perf_counter() - start


def main(count=200_000, repetitions=7):
    rng = np.random.default_rng(1)
    forms = [pypw85.ellipsoid_quaternion(rng.uniform(1, 3, (count, 3)), rng.normal(size=(count, 4))) for _ in range(2)]
    pairs = (rng.normal(size=(count, 3)) * 3, *forms)
    halves = [[x[: count // 2] for x in pairs], [x[count // 2:] for x in pairs]]
    one = min(elapsed([pairs]) for _ in range(repetitions))
    two = min(elapsed(halves) for _ in range(repetitions))
    print(f"contact_function, {count} pairs: {one:.3f} s in one thread, {two:.3f} s in two, ratio {one / two:.2f}")


if __name__ == "__main__":
    main()
