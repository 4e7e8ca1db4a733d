"""Directive ``percolation-table``: the tables of reference/percolation, `thresholds`, or `checks` for those by another method.

.. percolation-table:: thresholds

   Caption.
"""

import csv
import math
from pathlib import Path

from number_table import NumberTable

FOLDER = Path(__file__).resolve().parents[2] / "reference" / "percolation"


def read(name):
    with (FOLDER / name).open(encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def with_error(row, name):
    """A number with two digits of its error, as 0.2896(11)."""
    decimals = len(row[name].partition(".")[2])
    return f"{row[name]}({round(float(row[f'{name}_error']) * 10**decimals)})"


def thresholds():
    yield ["aspect ratio", ":math:`\\varphi_c`", ":math:`\\eta_c`", ":math:`\\eta_c`, any edge", ":math:`\\varphi_c`, 1995"]
    for row in read("percolation.csv"):
        yield [row["aspect"], *(with_error(row, name) for name in ("phi", "eta", "eta_any")), row["garboczi"]]


def checks():
    table = {row["aspect"]: row for row in read("percolation.csv")}
    yield ["aspect ratio", ":math:`\\eta_c`, spanning", ":math:`\\eta_c`, wrapping", "difference"]
    for row in read("check.csv"):
        other = table[row["aspect"]]
        error = math.hypot(float(row["eta_error"]), float(other["eta_error"]))
        difference = (float(row["eta"]) - float(other["eta"])) / error
        yield [row["aspect"], with_error(row, "eta"), with_error(other, "eta"), f"{difference:+.1f} σ".replace("-", "−")]


class PercolationTable(NumberTable):
    def files(self):
        return [FOLDER / name for name in ("percolation.csv", "check.csv")]

    def table(self):
        return {"thresholds": thresholds, "checks": checks}[self.arguments[0]]()


def setup(app):
    app.add_directive("percolation-table", PercolationTable)
    return {"parallel_read_safe": True}
