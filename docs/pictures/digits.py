"""Histogram of the correct digits of both forms of f."""

import numpy as np
from style import BLUE, ORANGE, figure, read_table, save


def main():
    rows = read_table("digits")
    digits = np.array([int(row["correct_digits"]) for row in rows])
    fig, ax = figure(height=3.6)
    for shift, name, colour in ((-0.2, "factorised", BLUE), (0.2, "rational", ORANGE)):
        ax.bar(digits + shift, [float(row[f"percent_{name}"]) for row in rows], 0.4, color=colour, label=f"{name} form")
    ax.set(xlabel="correct decimal digits of $f(\\lambda)$", ylabel="share of the values [%]", xlim=(8.4, 16.6))
    ax.set_xticks(digits[9:], [str(d) for d in digits[9:-1]] + ["≥ 16"])
    ax.legend(loc="upper left")
    save(fig, "digits.svg", "digits")


main()
