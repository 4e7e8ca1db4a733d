# SPDX-License-Identifier: BSD-3-Clause
"""The program of bench/languages.py in Python: see there."""

import sys
import time

import numpy as np

import pypw85

PAIRS = 1000
COPIES = {"overlap": 16, "contact": 16, "distance": 4, "overlap_volume": 1}  # of the pairs, that are computed as rows


def seconds(function):
    start = time.perf_counter()
    function()
    return time.perf_counter() - start


def columns(found):
    return found if isinstance(found, tuple) else (found,)


def write(results, file):
    for column in results:
        file.write(np.ascontiguousarray(column, dtype=float).tobytes())


def run(name, pairs, rounds, file):
    function, (r12, q1, q2) = getattr(pypw85, name), (list(x) for x in pairs)
    many = [np.tile(x, (COPIES[name], 1)) for x in pairs]

    def call_each(shift):
        """Calls the function for each pair, with the first form of the pair that is `shift` places behind."""
        for row in zip(r12, q1[shift:] + q1[:shift], q2):
            function(*row)

    call = min(seconds(lambda: call_each(k)) for k in range(rounds)) / PAIRS
    row = min(seconds(lambda: function(*many)) for _ in range(rounds)) / (PAIRS * COPIES[name])
    write([column[:PAIRS] for column in columns(function(*many))], file)
    write(zip(*(columns(function(*row)) for row in zip(*pairs))), file)
    print(f"{name},{1e9 * call!r},{1e9 * row!r}")


def main():
    numbers = np.fromfile(sys.argv[1])
    pairs = [x.reshape(PAIRS, -1) for x in np.split(numbers, [3 * PAIRS, 9 * PAIRS])]
    with open(sys.argv[2], "wb") as file:
        for name in COPIES:
            run(name, pairs, int(sys.argv[3]), file)


if __name__ == "__main__":
    main()
