"""What all pictures share: a white background, fit for print and for a dark page, and colours that colour-blind readers
can tell apart (M. Okabe and K. Ito, 2008)."""

import csv
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt

BLUE, ORANGE, GREEN, PURPLE = "#0072B2", "#D55E00", "#009E73", "#CC79A7"
BLACK, SKY, YELLOW = "#000000", "#56B4E9", "#F0A830"
HERE = pathlib.Path(__file__).resolve().parent
REFERENCE = HERE.parent.parent / "reference"
sys.path.append(str(HERE.parent))

import measurements  # noqa: E402
from measurements import read_table  # noqa: E402, F401

plt.rcParams.update(
    {
        "font.size": 11,
        "axes.grid": True,
        "grid.alpha": 0.3,
        "axes.spines.top": False,
        "axes.spines.right": False,
        "legend.frameon": False,
        "figure.facecolor": "white",
        "savefig.facecolor": "white",
        "svg.hashsalt": "pw85",
        "svg.fonttype": "path",
        "mathtext.fontset": "dejavusans",
    }
)


def figure(columns=1, width=7.0, height=4.2, **kwargs):
    return plt.subplots(1, columns, figsize=(width, height), constrained_layout=True, **kwargs)


def read_reference(name):
    """Rows of reference/NAME/NAME.csv, as dictionaries of texts."""
    with (REFERENCE / name / f"{name}.csv").open(newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def save(fig, name, table=None, data=None):
    """Writes the picture beside the scripts, the same bytes each time, with the source of the measured table or the file it shows."""
    metadata = {"Date": None} if name.endswith(".svg") else {}
    if table:
        metadata["Source"] = measurements.source(table)
    if data:
        metadata["Source"] = measurements.source_of_file(data)
    fig.savefig(HERE / name, metadata=metadata or None, dpi=160)
