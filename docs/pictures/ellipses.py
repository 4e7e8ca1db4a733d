"""The equation of state of hard ellipses and discs, from reference/ellipses/ellipses.csv."""

import numpy as np
from style import BLACK, BLUE, GREEN, ORANGE, REFERENCE, figure, read_reference, save

COLOURS = {"1": BLACK, "2": GREEN, "4": ORANGE, "6": BLUE}


def main():
    rows = [row for row in read_reference("ellipses") if row["ensemble"] == "NVT"]
    fig, (pressure, order) = figure(2, width=9, height=4.2)
    for aspect, colour in COLOURS.items():
        fraction, z, contacts, s2 = np.array(
            [[float(row[name]) for name in ("fraction", "z", "contacts", "order")] for row in rows if row["aspect"] == aspect]
        ).T
        pressure.plot(fraction, z, "o-", color=colour, markersize=5, linewidth=1, label=aspect if aspect != "1" else "discs")
        pressure.plot(fraction, contacts, "x", color=colour, markersize=7)
        if aspect != "1":
            order.plot(fraction, s2, "o-", color=colour, markersize=5, linewidth=1, label=aspect)
    eta = np.linspace(0.05, 0.5, 100)
    x = 2 * eta
    series = 1 + x + 0.78200 * x**2 + 0.53223 * x**3 + 0.33356 * x**4
    pressure.plot(eta, series, "--", color=BLACK, linewidth=1)
    pressure.set(xlabel="area fraction $\\varphi$", ylabel="$Z = \\beta P/\\rho$", yscale="log", ylim=(1, 30))
    pressure.set_yticks([1, 2, 5, 10, 20], ["1", "2", "5", "10", "20"])
    pressure.legend(title="aspect ratio", loc="upper left")
    order.set(xlabel="area fraction $\\varphi$", ylabel="order $S_2$", ylim=(0, 1))
    order.legend(title="aspect ratio", loc="upper left")
    save(fig, "ellipses.svg", data=REFERENCE / "ellipses" / "ellipses.csv")


main()
