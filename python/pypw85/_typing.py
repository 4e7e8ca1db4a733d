"""Types of arguments and results."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

# One row, as a list or tuple: the results are numbers. How many rows an array has is not known before the program runs.
Row = Sequence[float]
