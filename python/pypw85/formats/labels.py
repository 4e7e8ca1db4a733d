# SPDX-License-Identifier: BSD-3-Clause
"""Labelled images in files of NumPy (.npy): each grain becomes the ellipsoid, or the ellipse, that has its moments."""

from __future__ import annotations

import os
import warnings
from typing import Any
from collections.abc import Iterator

import numpy as np

from .._images import from_labels
from .._system import System
from ._errors import FileError, guarded
from ._files import check_input
from ._frames import Frame, Location
from ._options import Options

SUFFIXES: tuple[str, ...] = ()


def recognise(start: bytes) -> bool:
    return start.startswith(b"\x93NUMPY")


def locate(path: os.PathLike[str]) -> Iterator[Location]:
    yield Location(0)


@guarded
def load(path: os.PathLike[str], location: Location, options: Options) -> System:
    check_input(path)
    image = _open(path)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", UserWarning)  # which is among the notes
            system = from_labels(image, 1.0 if options.spacing is None else options.spacing)
    except ValueError as error:
        raise FileError(path, str(error).removeprefix("from_labels: "), 0) from None
    frame = Frame.of(path, 0, system)
    frame.source, frame.notes, frame.periodic = system.source, list(system.notes), (False, False, False)
    return frame.system(options)


def _open(path: os.PathLike[str]) -> Any:
    """The image, of which pixels are read when they are needed."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            return np.load(path, mmap_mode="r", allow_pickle=False)
    except (OSError, MemoryError):
        raise
    except Exception as error:  # NumPy parses a header as Python does, with errors of many kinds
        text = "NumPy cannot read it: the file is broken, truncated or not an array of numbers; write it again"
        raise FileError(path, text, 0) from error
