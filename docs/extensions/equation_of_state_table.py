"""Directive ``equation-of-state-table``: event chains beside constant pressure, or how far formulas are from the table of
reference/equation_of_state.

.. equation-of-state-table:: ensembles

   Caption.

.. equation-of-state-table:: formulas

   Caption.
"""

import sys
from pathlib import Path

from number_table import NumberTable
from virial_table import PATH, with_error

sys.path.append(str(Path(__file__).resolve().parents[2] / "reference" / "equation_of_state"))

import formulas
from csv_rows import read

MARGIN = 0.02


def percent(deviation):
    return f"{with_error(100 * deviation.value, 100 * deviation.error)} %"


def ensembles():
    """The headings, a row for each pressure, and χ²."""
    phi = ":math:`\\varphi`"
    yield ["aspect ratio", "start", ":math:`\\beta P v`", f"{phi} of the chains", f"{phi} at this pressure", "difference"]
    found = list(formulas.comparisons(read(formulas.TABLE)))
    for one in found:
        applied, difference = with_error(one.applied, one.applied_error), f"{one.sigmas:+.1f} σ".replace("-", "−")
        yield [one.aspect, one.start, f"{one.pressure:.4g}", f"{one.chains:g}", applied, difference]
    yield ["all", "", "", "", "", f":math:`\\chi^2 = {sum(one.sigmas**2 for one in found):.1f}` of {len(found)}"]


def first_beyond(deviations):
    """The last volume fraction at which a formula is within the margin, the next one, and how far off the formula is there."""
    beyond = next((i for i, one in enumerate(deviations) if abs(one.value) > MARGIN), len(deviations))
    within = f"{deviations[beyond - 1].phi:g}" if beyond else ""
    if beyond == len(deviations):
        return [within, "", ""]
    return [within, f"{deviations[beyond].phi:g}", percent(deviations[beyond])]


def worst(deviations):
    """How far off a formula is where it is most, and the volume fraction there."""
    one = max(deviations, key=lambda one: abs(one.value))
    return [percent(one), f"{one.phi:g}"]


def compared_formulas():
    """The headings, and a row for each shape."""
    yield [
        "aspect ratio",
        f"series within {100 * MARGIN:g} % up to :math:`\\varphi =`",
        "not at :math:`\\varphi =`",
        "off there by",
        "with the rest off by at most",
        "at :math:`\\varphi =`",
        "Parsons off by at most",
        "at :math:`\\varphi =`",
    ]
    rows = read(formulas.TABLE)
    for aspect in dict.fromkeys(row["aspect"] for row in rows):
        found = formulas.deviations(rows, aspect)
        yield [aspect, *first_beyond(found.series), *worst(found.with_rest), *worst(found.parsons)]


class EquationOfStateTable(NumberTable):
    def files(self):
        return [formulas.TABLE, PATH]

    def table(self):
        return {"ensembles": ensembles, "formulas": compared_formulas}[self.arguments[0]]()


def setup(app):
    app.add_directive("equation-of-state-table", EquationOfStateTable)
    return {"parallel_read_safe": True}
