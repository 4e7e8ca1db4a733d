"""Volume fractions and contacts of jammed random packings, from reference/packings/packings.csv."""

from fractions import Fraction

from style import BLUE, GREEN, ORANGE, PURPLE, REFERENCE, figure, read_reference, save


def main():
    rows = read_reference("packings")
    fig, panels = figure(2, width=9, height=3.8)
    for ax, name, title in zip(panels, ("fraction", "contacts"), ("volume fraction $\\varphi$", "contacts per ellipsoid")):
        for triaxial, sweeps, colour, marker, label in (
            (False, "30", BLUE, "o-", "spheroids, slow growth"),
            (True, "30", ORANGE, "D", "1.25:1:0.8, slow growth"),
            (False, "0", GREEN, "s--", "spheroids, no growth"),
            (True, "0", PURPLE, "d", "1.25:1:0.8, no growth"),
        ):
            chosen = [row for row in rows if (":" in row["shape"]) == triaxial and row["sweeps"] == sweeps]
            # A triaxial ellipsoid is shown at the ratio of its longest to its middle semi-axis.
            aspects = [float(Fraction(row["shape"].split(":")[0])) for row in chosen]
            values, errors = ([float(row[column]) for row in chosen] for column in (name, f"{name}_error"))
            ax.errorbar(aspects, values, errors, fmt=marker, color=colour, markersize=5, linewidth=1, label=label)
        ax.set(xscale="log", xlabel="aspect ratio", ylabel=title)
        ax.set_xticks([1 / 3, 1 / 2, 1, 2, 3], ["1/3", "1/2", "1", "2", "3"])
        ax.minorticks_off()
    panels[1].set_ylim(bottom=3.5)  # for the legend
    panels[1].legend(loc="lower right")
    save(fig, "packings.svg", data=REFERENCE / "packings" / "packings.csv")


main()
