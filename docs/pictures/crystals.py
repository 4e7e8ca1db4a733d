"""Volume fractions of dense crystals of ellipsoids, from reference/crystals/crystals.csv."""

import numpy as np
from style import BLUE, ORANGE, REFERENCE, figure, read_reference, save


def main():
    rows = [row for row in read_reference("crystals") if float(row["aspect"]) <= 3]
    aspects, fractions = (np.array([float(row[name]) for row in rows]) for name in ("aspect", "fraction"))
    fig, ax = figure()
    ax.plot(aspects, fractions, "o-", color=BLUE, markersize=4, label="two orientations")
    ax.axhline(fractions[0], color=ORANGE, linestyle="--", label="one orientation: stretched fcc crystal")
    ax.axvline(np.sqrt(3), color="0.6", linewidth=1)
    ax.annotate("$\\sqrt{3}$", (np.sqrt(3), 0.737), xytext=(4, 0), textcoords="offset points")
    ax.set(xlabel="longest over shortest semi-axis", ylabel="volume fraction $\\varphi$", xlim=(1, 3), ylim=(0.736, 0.776))
    ax.legend(loc="center right")
    save(fig, "crystals.svg", data=REFERENCE / "crystals" / "crystals.csv")


main()
