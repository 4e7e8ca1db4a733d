"""Draws all pictures of these pages again, from the library's output and the measured tables, with pypw85 on the path.

Usage: draw.py [LIBRARY], the shared library for the one picture that calls it directly.
"""

import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
PICTURES = (
    "accuracy", "closest_passage", "containment", "crystals", "curvature", "digits", "ellipses", "enclosing", "energy", "equation_of_state",
    "evaluations", "filled_hopper", "function_f", "nematic_order", "nematic_task", "packing", "packings", "percolation", "plot",
    "random_addition", "scaled_pair", "signed_distance", "throughput", "turning_plane", "virial",
)  # fmt: skip

for picture in PICTURES:
    subprocess.run([sys.executable, HERE / f"{picture}.py"], check=True)
    print(picture, flush=True)
for library in sys.argv[1:]:
    subprocess.run([sys.executable, HERE / "contact.py", library], check=True)
    print("contact", flush=True)
