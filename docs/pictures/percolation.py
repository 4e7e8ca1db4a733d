"""The volume fraction at which overlapping spheroids percolate, by aspect ratio: reference/percolation/percolation.csv."""

from fractions import Fraction

from style import BLUE, ORANGE, REFERENCE, figure, read_reference, save


def main():
    rows = read_reference("percolation")
    fig, axes = figure()
    curves = [("phi", "o-", BLUE, "this table"), ("garboczi", "x", ORANGE, "Garboczi and others, 1995")]
    for column, symbol, colour, label in curves:
        own = [(float(Fraction(row["aspect"])), float(row[column])) for row in rows if row[column]]
        axes.plot(*zip(*own), symbol, color=colour, label=label, markersize=5)
    axes.set(xscale="log", yscale="log", xlabel="aspect ratio", ylabel="volume fraction at the threshold")
    axes.legend()
    save(fig, "percolation.svg", data=REFERENCE / "percolation" / "percolation.csv")


main()
