"""Error of four ways to the contact function against the reference data, as CSV.

Usage: accuracy.py REFERENCE_DATA > accuracy.csv

For the pairs of the categories general_aspect_*, binned by the larger aspect ratio of the two ellipsoids: the error
|μ² - exact|/μ² in units of u·cond, with u = 2⁻⁵³ and the condition number of the file. A distance of closest approach d
counts as μ² = |r12|²/d². A last row takes all 15,300 pairs.
"""

import csv
import sys

import h5py
import numpy as np
import pypw85


def by_zheng(r12, q1, q2):
    with np.errstate(all="ignore"):
        distance = pypw85.zheng_ellipsoids(r12, q1, q2)
    return np.sum(r12**2, axis=1) / distance**2


METHODS = {
    "contact": lambda *pair: pypw85.contact(*pair)[0],
    "contact_function": lambda *pair: pypw85.contact_function(*pair)[0],
    "legacy_contact_function2": lambda *pair: pypw85.legacy.contact_function2(*pair)[0],
    "zheng_ellipsoids": by_zheng,
}


def aspect_ratios(q):
    eigenvalues = np.linalg.eigvalsh(pypw85.full(q))
    return np.sqrt(eigenvalues[:, 2] / np.abs(eigenvalues[:, 0]))


def main():
    with h5py.File(sys.argv[1]) as data:
        group = data["contact"]
        r12, q1, q2 = (group[name][:] for name in ("r12", "q1", "q2"))
        exact, cond, category = (group[name][:] for name in ("mu2", "cond", "category"))
        names = [name.decode() for name in group["category_names"][:]]
    aspect = np.maximum(aspect_ratios(q1), aspect_ratios(q2))
    general = np.isin(category, [i for i, name in enumerate(names) if name.startswith("general_aspect")])
    edges = 10.0 ** np.arange(0, 6.25, 0.5)
    errors = {
        name: np.abs(method(r12, q1, q2) - exact) / exact / (2.0**-53 * cond) for name, method in METHODS.items()
    }

    writer = csv.writer(sys.stdout, lineterminator="\n")
    writer.writerow(
        ["aspect_from", "aspect_to", "pairs"] + [f"{s}_{name}" for name in METHODS for s in ("median", "worst")]
    )
    bins = [(lower, upper, general & (aspect >= lower) & (aspect < upper)) for lower, upper in zip(edges, edges[1:])]
    for lower, upper, rows in bins + [("all", "", np.ones_like(general))]:
        values = [s(errors[name][rows]) for name in METHODS for s in (np.median, np.max)]
        ends = [x if isinstance(x, str) else f"{x:.4g}" for x in (lower, upper)]
        writer.writerow(ends + [np.count_nonzero(rows)] + [f"{x:.3g}" for x in values])


main()
