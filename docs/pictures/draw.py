"""Draws all pictures of these pages again, from the library's output and the measured tables, with pypw85 on the path.

Usage: draw.py [LIBRARY], the shared library for the one picture that calls it directly.
"""

import multiprocessing
import runpy
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot
import pypw85  # noqa: F401

HERE = Path(__file__).resolve().parent
PICTURES = (
    "accuracy", "closest_passage", "containment", "crystals", "curvature", "digits", "ellipses", "enclosing", "energy", "equation_of_state",
    "evaluations", "filled_hopper", "function_f", "nematic_order", "nematic_task", "packing", "packings", "percolation", "plot",
    "random_addition", "scaled_pair", "signed_distance", "throughput", "turning_plane", "virial",
)  # fmt: skip


def draw(picture, *arguments):
    sys.argv = [picture, *arguments]
    runpy.run_path(str(HERE / f"{picture}.py"), run_name="__main__")


# Each picture has a process of its own, with its own settings of Matplotlib, which was imported before: this takes longer than most
# pictures do.
for words in [*((picture,) for picture in PICTURES), *(("contact", library) for library in sys.argv[1:])]:
    process = multiprocessing.get_context("fork").Process(target=draw, args=words)
    process.start()
    process.join()
    if process.exitcode != 0:
        sys.exit(f"{words[0]}: status {process.exitcode}")
    print(words[0], flush=True)
