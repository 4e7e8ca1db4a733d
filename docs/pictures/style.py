"""What all pictures share: a white background, fit for print and for a dark page, and colours that colour-blind readers
can tell apart (M. Okabe and K. Ito, 2008)."""

import csv
import pathlib

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt  # noqa: E402

BLUE, ORANGE, GREEN, PURPLE = "#0072B2", "#D55E00", "#009E73", "#CC79A7"
BLACK, SKY, YELLOW = "#000000", "#56B4E9", "#F0A830"
HERE = pathlib.Path(__file__).parent
MEASUREMENTS = HERE.parent / "measurements"

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


def save(fig, name):
    """Writes the picture beside the scripts; the same bytes each time."""
    fig.savefig(HERE / name, metadata={"Date": None} if name.endswith(".svg") else None, dpi=160)


def read_table(name):
    """Rows of a measured table, as dictionaries of text."""
    with open(MEASUREMENTS / name, newline="") as file:
        return list(csv.DictReader(file))
