"""Whether old_layout.py writes the layout of pw85 1.0. Usage: check_old_layout.py PROGRAM REFERENCE_DATA"""

import subprocess
import sys
import tempfile
from pathlib import Path

import h5py
import numpy as np

with tempfile.TemporaryDirectory(prefix="pw85-") as folder:
    path = Path(folder) / "old.h5"
    subprocess.run([sys.executable, sys.argv[1], sys.argv[2], path], check=True)
    with h5py.File(path) as old:
        shapes = {name: old[name].shape for name in old}
        lambdas, f = old["lambdas"][:], old["F"][:]
    expected = {"radii": (3,), "directions": (12, 3), "spheroids": (108, 6), "lambdas": (9,), "F": (108, 108, 12, 9)}
    assert shapes == expected, shapes
    np.testing.assert_allclose(lambdas, np.arange(1, 10) / 10, rtol=1e-15)
    assert (f > 0).all()
