"""The order of hard spheroids against the volume fraction, from reference/equation_of_state/equation_of_state.csv."""

from style import BLACK, BLUE, GREEN, ORANGE, PURPLE, REFERENCE, figure, read_reference, save

COLOURS = {"5": BLUE, "1/5": ORANGE, "3": GREEN, "1/3": PURPLE}
MARKERS = {"random": "o", "aligned": "^"}
PUBLISHED, ERROR = 0.343, 0.003  # of the transition of 1/5: Guevara-Rodríguez and Odriozola, 2011


def main():
    rows = [row for row in read_reference("equation_of_state") if row["ensemble"] == "NVT"]
    fig, ax = figure()
    ax.axvspan(PUBLISHED - ERROR, PUBLISHED + ERROR, color=BLACK, alpha=0.2, linewidth=0, label="published, 1/5")
    for aspect, colour in COLOURS.items():
        for start, marker in MARKERS.items():
            here = [row for row in rows if (row["aspect"], row["start"]) == (aspect, start)]
            phi, order, error = zip(*([float(row[name]) for name in ("fraction", "order", "order_error")] for row in here))
            face = colour if start == "random" else "white"
            ax.errorbar(phi, order, error, fmt=marker, color=colour, markersize=6, markerfacecolor=face, linewidth=1)
        ax.plot([], [], "o", color=colour, label=aspect)
    ax.set(xlabel="volume fraction $\\varphi$", ylabel="nematic order $S$", ylim=(0, 1))
    ax.legend(title="aspect ratio", loc="upper left")
    save(fig, "nematic_order.svg", data=REFERENCE / "equation_of_state" / "equation_of_state.csv")


main()
