"""Reference data in the layout of pw85 1.0.

Usage: old_layout.py pw85_ref_data.h5 OUTPUT
"""

import sys

import h5py

with h5py.File(sys.argv[1]) as data, h5py.File(sys.argv[2], "w") as old:
    for name in ("radii", "directions", "spheroids"):
        old[name] = data[name][:]
    old["lambdas"] = data["lambdas"][1:-1]
    old["F"] = data["F"][..., 1:-1]
