"""Fractions of saturated random packings of ellipses, from reference/random_addition/random_addition.csv, and one of these packings."""

import numpy as np

import pypw85
from style import BLUE, ORANGE, REFERENCE, figure, read_reference, save


def main():
    rows = read_reference("random_addition")
    fig, (graph, packing) = figure(2, width=9, height=4.2)
    aspects, fractions, errors = np.array([[float(row[name]) for name in ("aspect", "fraction", "fraction_error")] for row in rows]).T
    graph.axhline(0.547, color=ORANGE, linewidth=1, label="discs, published")
    graph.errorbar(aspects, fractions, errors, fmt="o-", color=BLUE, markersize=5, linewidth=1, label="saturated")
    graph.set(xlabel="aspect ratio", ylabel="area fraction $\\varphi$")
    graph.legend(loc="upper right")
    pypw85.random_addition([[2, 1]], 36 * np.eye(2), seed=1).system.draw(ax=packing)
    packing.set(title="", xlabel="", ylabel="", xticks=[], yticks=[])
    packing.grid(False)
    save(fig, "random_addition.svg", data=REFERENCE / "random_addition" / "random_addition.csv")


main()
