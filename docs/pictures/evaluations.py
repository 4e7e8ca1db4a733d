"""Evaluations of f per pair, and what decides overlaps, against the aspect ratio."""

from style import BLUE, GREEN, ORANGE, PURPLE, SKY, figure, read_table, save


def main():
    rows = read_table("evaluations")
    aspect = [float(row["aspect"]) for row in rows]
    fig, (left, right) = figure(2, width=10)
    for name, label, colour in (("brent", "Brent and Newton in $\\lambda$", GREEN), ("contact", "fast solver", BLUE)):
        left.semilogx(
            aspect, [float(row[f"mean_{name}"]) for row in rows], marker="o", color=colour, label=f"{label}, mean"
        )
        largest = [float(row[f"largest_{name}"]) for row in rows]
        left.semilogx(aspect, largest, linestyle=":", marker=".", color=colour, label=f"{label}, largest")
    left.set(xlabel="aspect ratio", ylabel="evaluations of $f$ per pair", ylim=(0, 41))
    left.legend(fontsize=9, loc="upper left", ncol=2)

    tiers = {"quartic": SKY, "contact": ORANGE, "exact": PURPLE}
    shares = [[float(row[f"percent_{tier}"]) for row in rows] for tier in tiers]
    right.stackplot(aspect, shares, labels=list(tiers), colors=list(tiers.values()), alpha=0.75)
    right.set(
        xscale="log", xlabel="aspect ratio", ylabel="overlaps decided by the tier [%]", xlim=(1, 1e6), ylim=(0, 100)
    )
    right.legend(fontsize=9, loc="lower left", frameon=True)
    save(fig, "evaluations.svg", "evaluations")


main()
