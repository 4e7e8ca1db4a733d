"""Virial coefficients of hard spheroids over powers of the second one, with Vega's fits, by aspect ratio."""

import sys

from style import BLUE, HERE, ORANGE, figure, save

sys.path.append(str(HERE.parents[1] / "reference" / "virial"))

from coefficients import FITS, ORDERS, PATH, fit, rows

KINDS = {"prolate": (BLUE, "o"), "oblate": (ORANGE, "s")}


def draw(ax, order):
    """Points with error bars; the fit between them as a line."""
    for kind, (colour, marker) in KINDS.items():
        chosen = [row for row in rows() if row["shape"].split()[0] in ("sphere", kind)]
        aspects = [float(row["b" if kind == "oblate" else "c"]) for row in chosen]
        scales = [float(row["B2"]) ** (1 - order) for row in chosen]
        values = [float(row[f"B{order}"]) * scale for row, scale in zip(chosen, scales)]
        errors = [float(row[f"B{order}_error"]) * scale for row, scale in zip(chosen, scales)]
        ax.errorbar(aspects, values, errors, color=colour, marker=marker, markersize=4, linestyle="", label=kind)
        if order in FITS:
            fits = [fit(row, order) * scale for row, scale in zip(chosen, scales)]
            ax.plot(aspects, fits, color=colour, linewidth=0.8, label=f"{kind}, fit of 1997")
    ticks = [1, 2, 5, 10, 20]
    ax.set(xscale="log", xlabel="aspect ratio", title=f"$B_{order}/B_2^{order - 1}$")
    ax.set_xticks(ticks, [str(tick) for tick in ticks])
    ax.minorticks_off()


def main():
    fig, axes = figure(len(ORDERS), width=12, height=3.4)
    for ax, order in zip(axes, ORDERS):
        draw(ax, order)
    axes[0].legend(fontsize=9)
    save(fig, "virial.svg", data=PATH)


main()
