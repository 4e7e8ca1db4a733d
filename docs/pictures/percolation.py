"""The volume fraction at which overlapping spheroids percolate, by aspect ratio: reference/percolation/percolation.csv."""

import csv
from fractions import Fraction
from pathlib import Path

from style import BLUE, ORANGE, figure, save

PATH = Path(__file__).resolve().parents[2] / "reference" / "percolation" / "percolation.csv"


def main():
    with PATH.open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    fig, axes = figure()
    curves = [("phi", "o-", BLUE, "this table"), ("garboczi", "x", ORANGE, "Garboczi and others, 1995")]
    for column, symbol, colour, label in curves:
        own = [(float(Fraction(row["aspect"])), float(row[column])) for row in rows if row[column]]
        axes.plot(*zip(*own), symbol, color=colour, label=label, markersize=5)
    axes.set(xscale="log", yscale="log", xlabel="aspect ratio", ylabel="volume fraction at the threshold")
    axes.legend()
    save(fig, "percolation.svg")


main()
