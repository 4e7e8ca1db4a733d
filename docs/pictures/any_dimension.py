"""The time of a pair in n dimensions, that of its factorisations, and SciPy's."""

import numpy as np
from style import BLUE, GREEN, ORANGE, figure, read_table, save


def main():
    rows = read_table("any_dimension")
    dimensions = [int(row["dimensions"]) for row in rows]
    fig, ax = figure(width=6)
    for column, label, colour in (("scipy", "SciPy, eigenvectors and minimisation", ORANGE), ("rows", "pw85, a pair among many", BLUE)):
        ax.plot(dimensions, [float(row[column]) / 1e3 for row in rows], "o-", color=colour, label=label)
    factorisations = [float(row["evaluations"]) * float(row["factorisation"]) / 1e3 for row in rows]
    ax.plot(dimensions, factorisations, "s--", color=GREEN, label="its factorisations of a matrix")
    ax.set(yscale="log", xlabel="dimensions", ylabel="microseconds", xticks=np.array(dimensions))
    ax.legend(loc="center right", bbox_to_anchor=(1, 0.62))
    save(fig, "any_dimension.svg", "any_dimension")


main()
