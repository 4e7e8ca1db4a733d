"""Nematic order against the volume fraction: the runs of the task page, and long runs with more particles."""

import csv

import numpy as np
from style import BLACK, BLUE, HERE, ORANGE, figure, read_reference, save

ORDERS = HERE.parent / "tasks" / "nematic" / "orders.csv"
# Coexisting phases of the aspect ratio 3 by D. Frenkel and B. M. Mulder, Mol. Phys. 55, 1171 (1985)
COEXISTENCE = 0.507, 0.517


def points(rows, names):
    """Volume fractions, orders and errors, NaN where there is none."""
    table = [[np.nan if row[name] == "-" else float(row[name]) for name in names] for row in rows]
    return np.array(table).reshape(-1, 3).T


def main():
    with ORDERS.open(newline="", encoding="utf-8") as file:
        runs = list(csv.DictReader(file))
    long = [row for row in read_reference("equation_of_state") if row["aspect"] == "3" and row["ensemble"] == "NVT"]
    fig, ax = figure(width=6.4, height=4)
    ax.axvspan(*COEXISTENCE, color="0.85", label="coexistence (Frenkel and Mulder)")
    for start, marker, colour in (("isotropic", "o", BLUE), ("aligned", "^", ORANGE)):
        x, y, error = points([run for run in runs if run["start"] == start], ("volume fraction", "nematic order", "error"))
        ax.errorbar(x, y, error, fmt=marker, color=colour, capsize=3, label=f"this page, {start} start")
    x, y, error = points(long, ("fraction", "order", "order_error"))
    ax.errorbar(x, y, error, fmt="s", color=BLACK, markerfacecolor="white", markersize=4, capsize=3, label="972 or 1000 particles")
    ax.set(xlabel="volume fraction $\\varphi$", ylabel="nematic order S", ylim=(0, 1), xlim=(0.08, 0.6))
    ax.legend(loc="upper left", fontsize=9)
    save(fig, "nematic_task.svg", data=ORDERS)


main()
