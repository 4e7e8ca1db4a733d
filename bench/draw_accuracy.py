"""Draws what the program `accuracy` wrote. Usage: draw_accuracy.py FOLDER

Writes digits.png (histogram of the correct digits of both forms of f) and errors.png (error of the contact functions in
units of u·cond against the aspect ratio) into the folder.
"""

import csv
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt


def read(path):
    with path.open(newline="") as file:
        return list(csv.DictReader(file))


def draw_digits(folder):
    rows = read(folder / "digits.csv")
    digits = [int(row["digits"]) for row in rows]
    figure, axes = plt.subplots(figsize=(7, 4), layout="constrained")
    for shift, name, label in ((-0.2, "factorised", "factorisation"), (0.2, "rational", "rational form")):
        axes.bar([d + shift for d in digits], [float(row[name]) for row in rows], width=0.4, label=label)
    axes.set_xlabel("correct digits of f")
    axes.set_ylabel("per cent of the values")
    axes.legend()
    figure.savefig(folder / "digits.png", dpi=150)


def draw_errors(folder):
    rows = read(folder / "errors.csv")
    solvers = list(rows[0])[3:]
    figure, panels = plt.subplots(1, len(solvers), figsize=(3.2 * len(solvers), 3.4), sharex=True, sharey=True,
                                  layout="constrained")
    for axes, solver in zip(panels, solvers):
        points = [(float(row["aspect"]), float(row[solver])) for row in rows if row[solver]]
        axes.loglog([x for x, _ in points], [max(y, 1e-3) for _, y in points], ".", markersize=1)
        axes.axhline(4.0, color="black", linewidth=0.8)
        axes.set_title(solver, fontsize=9)
        axes.set_xlabel("larger aspect ratio")
    panels[0].set_ylabel("error / (u cond)")
    figure.savefig(folder / "errors.png", dpi=150)


if __name__ == "__main__":
    draw_digits(Path(sys.argv[1]))
    draw_errors(Path(sys.argv[1]))
