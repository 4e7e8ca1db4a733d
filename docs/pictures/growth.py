"""Time per pair or particle against their number, and the gain of a second thread."""

from style import BLACK, BLUE, GREEN, ORANGE, PURPLE, SKY, YELLOW, figure, read_table, save

FUNCTIONS = {
    "contact_batch": ("contact batch", BLUE),
    "overlap_batch": ("overlap batch", SKY),
    "contact_pairs": ("contact, list", GREEN),
    "overlap_pairs": ("overlap, list", YELLOW),
    "contact_derivatives_pairs": ("derivatives, list", ORANGE),
    "law_forces_pairs": ("forces of a law, list", PURPLE),
    "neighbors": ("neighbours, per particle", BLACK),
}


def main():
    rows = read_table("growth")
    fig, (times, gains) = figure(columns=2, width=10)
    for function, (label, colour) in FUNCTIONS.items():
        own = [row for row in rows if row["function"] == function]
        numbers = [float(row["number"]) for row in own]
        times.plot(numbers, [float(row["time"]) for row in own], "o-", color=colour, label=label, markersize=4)
        gains.plot(numbers, [float(row["speed_up"]) for row in own], "o-", color=colour, markersize=4)
        gains.plot(numbers, [float(row["limit"]) for row in own], ":", color=colour)
    times.set(xscale="log", yscale="log", xlabel="pairs or particles", ylabel="nanoseconds per pair or particle, one thread")
    gains.set(xscale="log", ylim=(0, 2.2), xlabel="pairs or particles", ylabel="two threads against one (dotted: two programs)")
    times.legend(fontsize=8, ncols=2, loc="upper center", bbox_to_anchor=(0.5, 0.85))
    save(fig, "growth.svg", "growth")


main()
