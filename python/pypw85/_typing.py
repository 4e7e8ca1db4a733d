# SPDX-License-Identifier: BSD-3-Clause
"""Types of arguments and results."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

Floats: TypeAlias = NDArray[np.float64]

# How many rows an array has is not known before the program runs. So the first vector of a call tells: numbers come of a list or tuple
# of numbers, arrays of an array or of a list of rows.
Row: TypeAlias = Sequence[float]
Rows: TypeAlias = NDArray[Any] | Sequence[Sequence[Any] | NDArray[Any]]

# Another argument beside a row: a form, as a list or from a function of this package.
One: TypeAlias = Row | NDArray[Any]
