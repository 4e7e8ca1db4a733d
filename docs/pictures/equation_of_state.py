"""The equation of state of hard spheroids, from reference/equation_of_state/equation_of_state.csv."""

import sys

import numpy as np
from style import BLACK, BLUE, GREEN, ORANGE, REFERENCE, figure, read_reference, save

sys.path.insert(0, str(REFERENCE / "equation_of_state"))
from formulas import parsons, series, virial_row, with_rest

COLOURS = {"1": BLACK, "2": GREEN, "3": ORANGE, "5": BLUE}
MARKERS = {"random": "o", "aligned": "^"}


def main():
    rows = read_reference("equation_of_state")
    fig, panels = figure(2, width=9, height=4.6, sharey=True)
    for ax, title in zip(panels, ("prolate", "oblate")):
        for aspect, colour in COLOURS.items():
            name = aspect if title == "prolate" or aspect == "1" else f"1/{aspect}"
            phi, virial = np.linspace(0.05, 0.5 if aspect in "12" else 0.55, 100), virial_row(name)
            ax.plot(phi, parsons(float(virial["B2"]), phi), color=colour, linewidth=1)
            ax.plot(phi, series(virial, phi)[0], "--", color=colour, linewidth=1)
            ax.plot(phi, with_rest(virial, phi)[0], ":", color=colour, linewidth=1)
            ax.plot([], [], "o-", color=colour, markersize=4, label=name)
            for start, marker in MARKERS.items():
                here = [row for row in rows if row["aspect"] == name and row["start"] == start and row["ensemble"] == "NVT"]
                points = np.array([[float(row["fraction"]), float(row["z"])] for row in here]).reshape(-1, 2).T
                ax.plot(*points, marker, color=colour, markersize=5, markerfacecolor=colour if start == "random" else "white")
        ax.set(xlabel="volume fraction $\\varphi$", title=title, xlim=(0.05, 0.57), ylim=(1, 30), yscale="log")
        ax.set_yticks([1, 2, 5, 10, 20], ["1", "2", "5", "10", "20"])
        ax.legend(title="aspect ratio", loc="upper left")
    panels[0].set_ylabel("$Z = \\beta P/\\rho$")
    save(fig, "equation_of_state.svg", data=REFERENCE / "equation_of_state" / "equation_of_state.csv")


main()
