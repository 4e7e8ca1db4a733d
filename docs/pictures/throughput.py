"""Pairs per second and thread, per SIMD target."""

import numpy as np
from style import BLUE, GREEN, ORANGE, figure, read_table, save

ASPECTS = {"2": BLUE, "10": ORANGE, "100": GREEN}
FUNCTIONS = {
    "contact_function": "contact_function\n(one at a time)",
    "contact_batch": "contact batch",
    "overlap_batch": "overlap batch",
}


def main():
    rows = {(row["function"], row["target"]): row for row in read_table("speed") if row["function"] in FUNCTIONS}
    keys = sorted(rows, key=lambda key: (list(FUNCTIONS).index(key[0]), list(rows).index(key)))
    labels = [FUNCTIONS[f] if f == "contact_function" else f"{FUNCTIONS[f]}\n{target}" for f, target in keys]
    fig, ax = figure(width=9)
    for i, (aspect, colour) in enumerate(ASPECTS.items()):
        rate = [1e3 / float(rows[key][f"aspect_{aspect}"]) for key in keys]
        bars = ax.bar(np.arange(len(keys)) + 0.27 * (i - 1), rate, 0.27, color=colour, label=f"aspect ratio {aspect}")
        ax.bar_label(bars, [f"{x:.0f}" if x >= 10 else f"{x:.2g}" for x in rate], fontsize=8, padding=1)
    ax.set_xticks(np.arange(len(keys)), labels, fontsize=9)
    ax.set(ylabel="million pairs per second, one thread")
    ax.grid(False, axis="x")
    ax.legend(loc="upper left")
    save(fig, "throughput.svg", "speed")


main()
