"""Error in units of u·cond against the aspect ratio."""

import numpy as np
from style import BLACK, BLUE, GREEN, ORANGE, PURPLE, figure, read_table, save

METHODS = {
    "contact": ("fast solver", BLUE, "o"),
    "contact_function": ("Brent's method", GREEN, "s"),
    "legacy_contact_function2": ("rational form", ORANGE, "^"),
    "zheng_ellipsoids": ("Zheng et al.", PURPLE, "D"),
}


def main():
    rows = [row for row in read_table("accuracy") if row["aspect_from"] != "all"]
    aspect = np.array([np.sqrt(float(row["aspect_from"]) * float(row["aspect_to"])) for row in rows])
    fig, axes = figure(2, width=10, sharey=True)
    for ax, statistic, title in zip(axes, ("median", "worst"), ("median", "worst of the pairs")):
        for method, (label, colour, marker) in METHODS.items():
            error = [float(row[f"{statistic}_{method}"]) for row in rows]
            ax.loglog(aspect, error, marker=marker, markersize=5, color=colour, label=label)
        ax.axhline(4, color=BLACK, linestyle="--", linewidth=1)
        ax.set(xlabel="aspect ratio (the larger of the two)", title=title)
    axes[0].text(1.2, 5, "bound promised: 4", va="bottom", fontsize=10)
    axes[0].set_ylabel("$|$error$|/\\mu^2$ in units of $u\\cdot$cond")
    axes[0].legend(loc="center right")
    save(fig, "accuracy.svg", "accuracy")


main()
