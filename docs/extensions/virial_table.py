"""Directive ``virial-table``: the virial coefficients of reference/virial/virial.csv, or how far Vega's fits are from them.

.. virial-table:: coefficients

   Caption.

.. virial-table:: fits

   Caption.
"""

import math
import sys
from pathlib import Path

from number_table import NumberTable

sys.path.append(str(Path(__file__).resolve().parents[2] / "reference" / "virial"))

from coefficients import FITS, ORDERS, PATH, fit, rows


def with_error(value, error):
    """The value with two digits of its error, as 18.365(12) or −41900(2600)."""
    decimals = 1 - math.floor(math.log10(error))
    digits = round(error * 10**decimals) * 10 ** max(0, -decimals)
    return f"{round(value, decimals):.{max(0, decimals)}f}({digits})".replace("-", "−")


def coefficients():
    """The headings and the rows of the table of coefficients."""
    yield ["shape", ":math:`B_2/v`", *(f":math:`B_{n}/v^{n - 1}`" for n in ORDERS)]
    for row in rows():
        cells = [with_error(float(row[f"B{n}"]), float(row[f"B{n}_error"])) for n in ORDERS]
        yield [row["shape"], f"{float(row['B2']):.6f}", *cells]


def deviation(row, order):
    """How far the fit is above the coefficient, in percent and in standard errors of the coefficient."""
    value, error = float(row[f"B{order}"]), float(row[f"B{order}_error"])
    difference = fit(row, order) - value
    return f"{100 * difference / abs(value):+.2g} %, {difference / error:+.1f} σ".replace("-", "−")


def fits():
    """The headings and the rows of the table of fits."""
    yield ["shape", *(f":math:`B_{n}`" for n in FITS)]
    for row in rows():
        yield [row["shape"], *(deviation(row, order) for order in FITS)]


class VirialTable(NumberTable):
    def files(self):
        return [PATH]

    def table(self):
        return {"coefficients": coefficients, "fits": fits}[self.arguments[0]]()


def setup(app):
    app.add_directive("virial-table", VirialTable)
    return {"parallel_read_safe": True}
