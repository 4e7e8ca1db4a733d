# SPDX-License-Identifier: BSD-3-Clause
"""Splats as other programs pack them: .splat (antimatter15), and .spz of Niantic in its versions 2 to 4."""

from __future__ import annotations

import gzip
import os
import zlib
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from .._typing import Floats
from .._words import counted
from ._errors import FileError
from ._gaussians import Gaussians
from ._splats_ply import completed

SPZ = b"NGSP"
_SPLAT = np.dtype([("position", "<f4", 3), ("lengths", "<f4", 3), ("color", "u1", 4), ("rotation", "u1", 4)])
_HEADER = np.dtype([("magic", "<u4"), ("version", "<u4"), ("count", "<u4"), ("degree", "u1"), ("fraction", "u1"), ("flags", "u1"),
                    ("streams", "u1")])  # fmt: skip
_HEADER_OF_4 = 32
# Largest ratios of a stream of deflate, and of a block of Zstandard (128 KiB from four bytes)
_DEFLATE, _ZSTANDARD = 1100, 1 << 15
_BLOCK = 1 << 20


def read_splat(path: os.PathLike[str]) -> Gaussians:
    """Rows of 32 bytes without a header: position and lengths in single precision, a colour, and w x y z in a byte each."""
    size = os.path.getsize(path)
    if size % _SPLAT.itemsize or not size:
        raise FileError(path, f"a .splat file has {_SPLAT.itemsize} bytes for each splat, and this one has {size} bytes in all: it is "
                        "truncated, or of another kind; write it again", 0)  # fmt: skip
    rows = np.fromfile(path, _SPLAT)
    quaternions = (rows["rotation"].astype(np.float64) - 128) / 128
    lengths = rows["lengths"].astype(np.float64)
    wrong = ~(lengths >= 0).all(axis=1)
    if wrong.any():
        raise FileError(path, f"splat {int(wrong.argmax()) + 1} has a length that is not >= 0: this is not a .splat file, or it is "
                        "broken; write it again", 0)  # fmt: skip
    return Gaussians(rows["position"].astype(np.float64), lengths, quaternions, "of .splat", "in a byte each")


class _Packed(NamedTuple):
    """Arrays that follow the header of an .spz file, without colours."""

    positions: bytes
    scales: bytes
    rotations: bytes


def read_spz(path: os.PathLike[str], is_zipped: bool) -> Gaussians:
    try:
        with gzip.open(path) if is_zipped else open(path, "rb") as file:
            header = _header(path, file)
            version, count = int(header["version"]), int(header["count"])
            if version < 4:
                packed = _sequential(path, file, version, count, is_zipped)
            else:
                packed = _from_streams(path, file, int(header["degree"]), int(header["streams"]), count)
    except (EOFError, gzip.BadGzipFile, zlib.error) as error:
        raise FileError(path, f"what is compressed cannot be read ({error}): it is broken or truncated; write it again", 0) from None
    # Whole numbers of 24 bits with a sign, in the upper bytes of 32
    whole = np.zeros((3 * count, 4), dtype=np.uint8)
    whole[:, 1:] = np.frombuffer(packed.positions, np.uint8).reshape(-1, 3)
    centers = np.ldexp((whole.view("<i4").ravel() >> 8).astype(np.float64).reshape(-1, 3), -int(header["fraction"]))
    lengths = np.exp(np.frombuffer(packed.scales, np.uint8).reshape(-1, 3) / 16.0 - 10.0)
    quaternions = _three_bytes(packed.rotations) if version == 2 else _smallest_three(packed.rotations)
    return Gaussians(centers, lengths, quaternions, f"of .spz, version {version}", "as packed there")


def _header(path: os.PathLike[str], file: Any) -> Any:
    start = file.read(_HEADER.itemsize)
    if len(start) < _HEADER.itemsize:
        raise FileError(path, f"the file ends within the header of .spz, after {len(start)} bytes: it is truncated; write it again", 0)
    header = np.frombuffer(start, _HEADER)[0]
    if start[:4] != SPZ or not 2 <= header["version"] <= 4:
        what = f"it is version {header['version']}" if start[:4] == SPZ else f"it begins with {start[:4]!r}, not {SPZ!r}"
        raise FileError(path, f"only versions 2 to 4 of .spz files are read, and {what}: write it as one of these, or as .ply", 0)
    return header


def _refuse_short(path: os.PathLike[str], count: int, wanted: int, there: int) -> None:
    if there < wanted:
        raise FileError(path, f"says that it has {counted(count, 'splat')}, but is too small for them: it is truncated; write it again", 0)


def _sequential(path: os.PathLike[str], file: Any, version: int, count: int, is_zipped: bool) -> _Packed:
    """Positions, opacities, colours, scales and rotations, one behind the other."""
    sizes = [9 * count, 4 * count, 3 * count, (3 if version == 2 else 4) * count]
    _refuse_short(path, count, sum(sizes), os.path.getsize(path) * (_DEFLATE if is_zipped else 1))
    positions, _, scales, rotations = parts = [file.read(size) for size in sizes]
    _refuse_short(path, count, sum(sizes), sum(map(len, parts)))
    return _Packed(positions, scales, rotations)


def _from_streams(path: os.PathLike[str], file: Any, degree: int, streams: int, count: int) -> _Packed:
    """A table of sizes, and streams of Zstandard: positions, opacities, colours, scales, rotations, and harmonics if there are any."""
    size = os.path.getsize(path)
    start = int.from_bytes(file.read(4), "little")
    if streams != (5 if degree == 0 else 6) or not _HEADER_OF_4 <= start <= size - 16 * streams:
        raise FileError(path, f"the header of .spz names {streams} streams with a table at byte {start} of {size}: the file is broken or "
                        "truncated; write it again", 0)  # fmt: skip
    file.seek(start)
    table = np.frombuffer(file.read(16 * streams), "<u8").reshape(-1, 2).tolist()
    place, found = start + 16 * streams, []
    for (packed, unpacked), wanted in zip(table, [9 * count, count, 3 * count, 3 * count, 4 * count]):
        if unpacked != wanted or place + packed > size or wanted > _ZSTANDARD * packed:
            raise FileError(path, f"the stream at byte {place} of .spz has {packed} bytes for {unpacked}, and {count} splats need "
                            f"{wanted}: the file is broken or truncated; write it again", 0)  # fmt: skip
        file.seek(place)
        found.append(file.read(packed) if wanted != count else b"")
        place += packed
    return _Packed(*(_unpacked(path, found[k], wanted) for k, wanted in ((0, 9 * count), (3, 3 * count), (4, 4 * count))))


def _unpacked(path: os.PathLike[str], data: bytes, wanted: int) -> bytes:
    """Never more than what is wanted, whatever the stream says of itself."""
    try:
        import zstandard
    except ImportError:
        raise FileError(path, ".spz files of version 4 are compressed by Zstandard: install the Python package zstandard, or convert "
                        "the file (splat-transform INPUT.spz OUTPUT.ply)", 0) from None  # fmt: skip
    parts, there = [], 0
    try:
        with zstandard.ZstdDecompressor(max_window_size=1 << 27).stream_reader(data) as reader:
            while there <= wanted and (part := reader.read(min(_BLOCK, wanted + 1 - there))):
                parts.append(part)
                there += len(part)
    except zstandard.ZstdError as error:
        raise FileError(path, f"what is compressed cannot be read ({error}): it is broken; write it again", 0) from None
    if there != wanted:
        raise FileError(path, f"a stream of .spz holds {there} bytes instead of {wanted}: it is broken or truncated; write it again", 0)
    return b"".join(parts)


def _three_bytes(data: bytes) -> Floats:
    """x y z of version 2. w is not negative."""
    xyz = np.frombuffer(data, np.uint8).reshape(-1, 3) / 127.5 - 1
    return completed(xyz, np.zeros(len(xyz), dtype=np.intp))


def _smallest_three(data: bytes) -> Floats:
    """Two bits say which of x y z w is the largest and left out. The others have a sign and nine bits, from 0 to √½."""
    packed: NDArray[np.uint32] = np.frombuffer(data, "<u4").astype(np.uint32)
    parts = np.stack([packed >> shift & 1023 for shift in (20, 10, 0)], axis=1)
    three = np.sqrt(0.5) / 511 * (parts & 511) * np.where(parts & 512, -1, 1)
    return completed(three, (packed >> 30).astype(np.intp))[:, [3, 0, 1, 2]]
