#!/usr/bin/env python3
"""Puts a library into a folder of its own under the driver's name. Usage: as_driver.py LIBRARY FOLDER"""

import shutil
import sys
from pathlib import Path

folder = Path(sys.argv[2])
folder.mkdir(exist_ok=True)
shutil.copyfile(sys.argv[1], folder / "libcuda.so.1")
