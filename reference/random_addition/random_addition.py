# SPDX-License-Identifier: BSD-3-Clause
"""Makes saturated random packings of ellipses, and writes runs.csv with one row for each and random_addition.csv with their means.

It needs pypw85 on the path. Runs that the folder already has are not made again. So a program that was interrupted goes on where it
was, and a run is made anew if its row is deleted. More SEEDS add runs.

Ellipses are put at random places with random angles, one after the other, and stay where they overlap none (random sequential
addition), until no place and no angle is left (`pypw85.random_addition`). The cell is a periodic square, whose area is that of
AREAS ellipses. The fraction of a run has a variance that is inversely proportional to the area, and no bias of the cell beyond
correlations, which reach over a few ellipses.
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

import numpy as np

import pypw85

sys.path.append(str(Path(__file__).resolve().parents[1]))
from csv_rows import read, write

FOLDER = Path(__file__).parent
ASPECTS = ("1", "1.25", "1.5", "1.75", "2", "2.5", "3", "4")
AREAS = 40_000
SEEDS = 6  # of each aspect ratio


def run(aspect: str, seed: str) -> dict[str, str]:
    """A packing of ellipses with the semi-axes a and 1. Its row is exact: the exact test finds no overlap in what is counted."""
    long = float(aspect)
    edge = np.sqrt(AREAS * np.pi * long)
    found = pypw85.random_addition([[long, 1.0]], edge * np.eye(2), seed=int(seed))
    overlaps = len(found.system.overlaps().mu)
    if not found.is_saturated or overlaps:
        raise RuntimeError(f"aspect {aspect}, seed {seed}: {found.end}, {overlaps} overlaps")
    return {
        "aspect": aspect, "seed": seed, "areas": str(AREAS), "particles": str(len(found.system)),
        "fraction": f"{found.system.packing_fraction:.8f}", "order": f"{pypw85.nematic_order(found.system) if long > 1 else np.nan:.4f}",
        "version": pypw85.__version__,
    }  # fmt: skip


def table(rows: list[dict[str, str]]) -> list[dict[str, str]]:
    """Means of each aspect ratio, with standard errors from the runs."""
    result = []
    for aspect in ASPECTS:
        fractions = [float(row["fraction"]) for row in rows if row["aspect"] == aspect]
        error = np.std(fractions, ddof=1) / np.sqrt(len(fractions))
        result.append({"aspect": aspect, "fraction": f"{np.mean(fractions):.6f}", "fraction_error": f"{error:.6f}",
                       "runs": str(len(fractions)), "areas": str(AREAS), "version": rows[0]["version"]})  # fmt: skip
    return result


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", nargs="?", type=Path, default=FOLDER)
    folder = parser.parse_args().folder
    runs = {(row["aspect"], row["seed"]): row for row in read(folder / "runs.csv")}
    wanted = [(aspect, str(seed)) for aspect in ASPECTS for seed in range(1, SEEDS + 1)]
    for key in wanted:
        if key not in runs:
            runs[key] = row = run(*key)
            write(folder / "runs.csv", (runs[one] for one in wanted if one in runs))
            print(*row.values(), flush=True)
    write(folder / "random_addition.csv", table([runs[one] for one in wanted]))


if __name__ == "__main__":
    main()
