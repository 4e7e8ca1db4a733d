"""Correct digits of both forms of f against the reference data, as CSV.

Usage: digits.py REFERENCE_DATA > digits.csv

Row i: the percentage of the values of /F, without those at λ = 0 and 1 where f = 0, with i correct decimal digits,
floor(-log10(relative error)); the last row has 16 or more.
"""

import csv
import sys

import h5py
import numpy as np
import pypw85

FORMS = {"factorised": pypw85.f, "rational": pypw85.legacy.f2}
BINS = 17


def correct_digits(actual, exact):
    with np.errstate(divide="ignore"):
        digits = np.floor(-np.log10(np.abs(actual / exact - 1)))
    return np.clip(digits, 0, BINS - 1).astype(int)


def main():
    with h5py.File(sys.argv[1]) as data:
        lambdas, directions, spheroids = (data[name][:] for name in ("lambdas", "directions", "spheroids"))
        exact = data["F"][:, :, :, 1:-1]
    q1 = spheroids[:, np.newaxis, np.newaxis, np.newaxis]
    q2 = spheroids[np.newaxis, :, np.newaxis, np.newaxis]
    r12 = directions[:, np.newaxis]
    counts = {
        name: np.bincount(correct_digits(f(lambdas[1:-1], r12, q1, q2), exact).ravel(), minlength=BINS)
        for name, f in FORMS.items()
    }
    writer = csv.writer(sys.stdout, lineterminator="\n")
    writer.writerow(["correct_digits"] + [f"percent_{name}" for name in FORMS])
    for i in range(BINS):
        writer.writerow([i] + [f"{100 * counts[name][i] / exact.size:.4f}" for name in FORMS])


main()
